// What the scene view draws and says.

#include "app/model/rest_marks.h"
#include "app/model/sentences.h"
#include "app/ui/scene/body_text.h"
#include "app/ui/scene/free_area.h"
#include "app/ui/scene/guide_labels.h"
#include "app/ui/scene/label_places.h"
#include "look_scenes.h"
#include "scene_bench.h"
#include "sim/effects/springs.h"

#include "app/model/numbers.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <ctime>
#include <numbers>

using namespace app;

class SceneDrawingTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { useOwnSettings(m_settings); }
    void captionsSayWhatIsDone_data();
    void captionsSayWhatIsDone();
    void pullsAreDrawnInsideAFrameOnly();
    void eachExtraChangesThePicture_data();
    void eachExtraChangesThePicture();
    void aBarMarksTheLengthAtRest();
    void nothingOfRestLengthsIsDrawnWhileTheyAreOff();
    void aGhostIsDrawnWhereItDiffers();
    void theTrailFollowsForwardOnly();
    void arrowsHaveAReadableScale_data();
    void arrowsHaveAReadableScale();
    void signsAtTheEdgeKeepApart_data();
    void signsAtTheEdgeKeepApart();
    void namesKeepApart_data();
    void namesKeepApart();
    void aNameCoversNoArrow_data();
    void aNameCoversNoArrow();
    void whatABoxCoversOfALine_data();
    void whatABoxCoversOfALine();
    void aThemeChangeRepaints();
    void namesAndNumbersAreReadable_data();
    void namesAndNumbersAreReadable();
    void paintingTakesLittleTime();

private:
    QTemporaryDir m_settings;
};

void SceneDrawingTest::captionsSayWhatIsDone_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    QTest::addColumn<int>("phase");
    QTest::addColumn<QString>("caption");
    const QString published = "published";
    const QString simultaneous = "semi_implicit_euler";
    QTest::newRow("between frames") << published << 1.0 << 0 << "";
    QTest::newRow("published, a pull")
        << published << 1.0 << 1
        << "Inside frame 2: pulls go straight onto the velocity, nothing has moved yet.";
    QTest::newRow("published, feet moved")
        << published << 1.0 << 4 << "Inside frame 2: feet moved already, body not yet.";
    QTest::newRow("gathered") << simultaneous << 1.0 << 2
                              << "Inside frame 2: accelerations are gathered, nothing has moved yet.";
    QTest::newRow("kicked") << simultaneous << 1.0 << 3
                            << "Inside frame 2: velocities have changed, nothing has moved yet.";
    QTest::newRow("second step of two")
        << simultaneous << 0.5 << 7
        << "Inside frame 2, step 2 of 2: accelerations are gathered, nothing has moved in it yet.";
    QTest::newRow("moved, walls to come")
        << simultaneous << 1.0 << 5 << "Inside frame 2: everything has moved, walls to come.";
    QTest::newRow("one step of two") << simultaneous << 0.5 << 6 << "Inside frame 2: 1 of 2 steps are done.";
}

void SceneDrawingTest::captionsSayWhatIsDone()
{
    QFETCH(QString, method);
    QFETCH(double, h);
    QFETCH(int, phase);
    QFETCH(QString, caption);
    SceneBench bench("room");
    bench.session.setMethod(method);
    bench.session.setStepSize(h);
    bench.session.goTo({2, phase});
    QCOMPARE(bench.view.caption(), caption);
}

void SceneDrawingTest::pullsAreDrawnInsideAFrameOnly()
{
    SceneBench bench;
    bench.session.setMethod("semi_implicit_euler");
    const QColor spring = bench.theme.tokens().spring;
    const QColor gravity = bench.theme.tokens().gravity;
    QCOMPARE(bench.pixels(spring), 0);
    bench.session.phaseForward();
    QVERIFY(bench.pixels(spring) > 60);
    QCOMPARE(bench.pixels(gravity), 0);
    bench.session.phaseForward();
    QVERIFY(bench.pixels(gravity) > 60);
    bench.session.goTo({1, 0});
    QCOMPARE(bench.pixels(spring) + bench.pixels(gravity), 0);
}

void SceneDrawingTest::eachExtraChangesThePicture_data()
{
    QTest::addColumn<int>("extra");
    QTest::newRow("trails") << 0;
    QTest::newRow("velocity arrows") << 1;
    QTest::newRow("grid") << 2;
    QTest::newRow("explaining lines") << 3;
    QTest::newRow("eyes") << 4;
    QTest::newRow("ghost") << 5;
}

void SceneDrawingTest::eachExtraChangesThePicture()
{
    QFETCH(int, extra);
    SceneBench bench(extra == 3 ? "lone" : "creature");
    for (int i = 0; i < 12; ++i)
        bench.session.frameForward();
    if (extra == 5) {
        bench.session.goTo({4, 0});
        bench.session.setParameter("gravity", 1.4);
        bench.session.goTo({12, 0});
    }
    const QImage before = bench.image();
    bool Extras::*const members[] = {&Extras::trails, &Extras::velocities, &Extras::grid,
                                     &Extras::guides, &Extras::eyes,       &Extras::ghost};
    Extras extras = bench.view.extras();
    extras.*members[extra] = !(extras.*members[extra]);
    bench.view.setExtras(extras);
    QVERIFY(bench.image() != before);
    bench.view.setExtras(Extras());
    QVERIFY(bench.image() == before);
}

namespace {

/// A spring, 100 px long at rest, from a body that stands at (100, 200) to a foot 60 px to its right.
lessons::Step pressedSpring()
{
    lessons::Step step = look_scenes::step("pressed", {}, {});
    step.scene = [](const sim::Values &) {
        sim::Scene scene = look_scenes::pointsAt({{160, 200}, {100, 200}});
        scene.start.inverseMass[1] = 0.0;
        scene.effects.push_back(
            std::make_shared<sim::Springs>(std::vector<sim::Spring>{{0, 1, 0.2, 100.0}}, 2));
        return scene;
    };
    step.look = [](const sim::Scene &scene, const sim::Values &) { return look_scenes::feetOnly(scene); };
    return step;
}

}

void SceneDrawingTest::aBarMarksTheLengthAtRest()
{
    SceneBench bench({pressedSpring()});
    const std::vector<RestMark> marks = restMarks(bench.session.picture().segment->scene,
                                                  bench.session.picture().state, bench.view.shown().look());
    QCOMPARE(marks.size(), std::size_t{1});
    QCOMPARE(marks[0].rest.mover, 0); // the end that can go
    QVERIFY(sim::length(marks[0].rest.place - sim::Vec2{200, 200}) < 1e-9);
    Extras extras = bench.view.extras();
    extras.grid = extras.guides = false;
    bench.view.setExtras(extras);
    const QColor spring = bench.theme.tokens().spring;
    QCOMPARE(bench.pixels(spring), 0);
    extras.rests = true;
    bench.view.setExtras(extras);
    const QPoint bar = bench.view.mapFromScene(200.0, 200.0);
    const QImage image = bench.image();
    int onBar = 0;
    for (int y = bar.y() - 5; y <= bar.y() + 5; ++y) {
        for (int x = bar.x() - 1; x <= bar.x() + 1; ++x)
            onBar += image.pixelColor(x, y) == spring ? 1 : 0;
    }
    QVERIFY2(onBar >= 8, qPrintable(QString::number(onBar)));
}

void SceneDrawingTest::nothingOfRestLengthsIsDrawnWhileTheyAreOff()
{
    SceneBench bench({pressedSpring()});
    const QImage off = bench.image();
    Extras extras = bench.view.extras();
    extras.rests = true;
    bench.view.setExtras(extras);
    QVERIFY(bench.image() != off);
    extras.rests = false;
    bench.view.setExtras(extras);
    QVERIFY(bench.image() == off);
}

void SceneDrawingTest::aGhostIsDrawnWhereItDiffers()
{
    SceneBench bench;
    bench.session.goTo({12, 0});
    bench.session.goTo({4, 0});
    const QImage before = bench.image();
    bench.session.setParameter("gravity", 1.4);
    QVERIFY(bench.session.ghost().has_value());
    QVERIFY2(bench.image() == before, "where both runs are the same there is nothing to see");
    bench.session.goTo({12, 0});
    const QImage with = bench.image();
    bench.session.forgetGhost();
    QVERIFY(bench.image() != with);
}

void SceneDrawingTest::theTrailFollowsForwardOnly()
{
    SceneBench bench;
    Trail trail;
    const auto at = [&](sim::Cursor cursor) {
        bench.session.goTo(cursor);
        trail.follow(bench.session.timeline());
        return static_cast<int>(trail.marks().size());
    };
    for (int frame = 0; frame <= 5; ++frame)
        QCOMPARE(at({frame, 0}), frame + 1);
    QCOMPARE(at({5, 2}), 6);
    QCOMPARE(at({3, 0}), 4);  // going back takes frames away
    QCOMPARE(at({90, 0}), 1); // a jump takes all
    for (int frame = 91; frame < 130; ++frame)
        at({frame, 0});
    QCOMPARE(static_cast<int>(trail.marks().size()), static_cast<int>(Trail::length) + 1);
    bench.session.setStepSize(0.5);
    QCOMPARE(at({129, 0}), 1); // another run
}

void SceneDrawingTest::arrowsHaveAReadableScale_data()
{
    QTest::addColumn<double>("longest");
    QTest::addColumn<double>("settled");
    QTest::addColumn<double>("unit");
    QTest::newRow("of a calm scene") << 2.3 << 0.0 << 1.0;
    QTest::newRow("of a strong pull") << 34.0 << 0.0 << 20.0;
    QTest::newRow("of a weak one") << 0.004 << 0.0 << 0.002;
    QTest::newRow("of nothing") << 0.0 << 0.0 << 1.0;
    QTest::newRow("that still fits stays") << 2.3 << 5.0 << 5.0;
    QTest::newRow("that is too small goes") << 2.3 << 0.5 << 1.0;
    QTest::newRow("that is far too large goes") << 2.3 << 50.0 << 1.0;
}

void SceneDrawingTest::arrowsHaveAReadableScale()
{
    QFETCH(double, longest);
    QFETCH(double, settled);
    QFETCH(double, unit);
    QCOMPARE(arrowUnit(longest, settled > 0.0 ? std::optional(settled) : std::nullopt), unit);
}

void SceneDrawingTest::signsAtTheEdgeKeepApart_data()
{
    QTest::addColumn<QPointF>("middle");
    QTest::addColumn<int>("least");
    QTest::newRow("all in one direction") << QPointF(2000, 200) << 1;
    QTest::newRow("to all sides") << QPointF(275, 240) << 2;
    QTest::newRow("far beyond") << QPointF(4e5, -3e5) << 1;
    QTest::newRow("so far that its square is no number") << QPointF(1e200, -1e200) << 1;
}

void SceneDrawingTest::signsAtTheEdgeKeepApart()
{
    QFETCH(QPointF, middle);
    QFETCH(int, least);
    SceneBench bench;
    Shown shown;
    shown.picture = bench.session.picture();
    shown.text = bench.theme.ui(12);
    const Camera camera(QTransform().translate(300, 235).scale(12, 12).translate(-middle.x(), -middle.y()));
    const QRectF view(0, 0, 600, 470);
    const QRectF free = view.adjusted(12, 40, -12, -48);
    const std::vector<EdgeMarker> markers = edgeMarkers(shown, camera, view, free, {});
    QVERIFY(static_cast<int>(markers.size()) >= least);
    int bodies = 0;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        bodies += markers[i].bodies;
        QVERIFY2(!markers[i].text.contains("inf"), qPrintable(markers[i].text));
        QVERIFY(free.adjusted(-1, -1, 1, 1).contains(markers[i].label));
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(!markers[i].label.intersects(markers[j].label));
    }
    QCOMPARE(bodies, 3);
}

void SceneDrawingTest::namesKeepApart_data()
{
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("phase");
    QTest::newRow("at the start") << 0 << 0;
    QTest::newRow("in the middle of a swing") << 3 << 0;
    QTest::newRow("inside a frame") << 3 << 1;
}

void SceneDrawingTest::namesKeepApart()
{
    QFETCH(int, frame);
    QFETCH(int, phase);
    SceneBench bench("lone");
    bench.session.goTo({frame, phase});
    Shown shown;
    shown.picture = bench.session.picture();
    shown.gathered = bench.session.gathered();
    shown.text = bench.theme.ui(12);
    shown.selected = 0;
    const Camera camera(bench.view.viewportTransform());
    const QRectF view(bench.view.viewport()->rect());
    const QRectF name = nameBox(shown, camera, view);
    QCOMPARE(name.isEmpty(), phase > 0); // a card stands in its place
    const std::vector<GuideLabel> labels = guideLabels(shown, camera, bench.theme, view);
    QCOMPARE(labels.size(), 1U);
    QVERIFY(!labels[0].box.intersects(name));
    for (const QRectF &body : bodyBoxes(shown, camera))
        QVERIFY(!labels[0].box.intersects(body));
}

void SceneDrawingTest::aNameCoversNoArrow_data()
{
    QTest::addColumn<double>("degrees");
    for (int degrees = 0; degrees < 360; degrees += 30)
        QTest::addRow("%d degrees", degrees) << double(degrees);
}

void SceneDrawingTest::aNameCoversNoArrow()
{
    QFETCH(double, degrees);
    SceneBench bench("lone");
    Shown shown;
    shown.picture = bench.session.picture();
    shown.text = bench.theme.ui(12);
    const double angle = degrees * std::numbers::pi / 180.0;
    const sim::Vec2 pull = {3.0 * std::cos(angle), 3.0 * std::sin(angle)};
    shown.picture.guides = {
        {lessons::Guide::Shape::arrow, shown.state().at(0), pull, 0.0, "a pull with a long name"}};
    const Camera camera(bench.view.viewportTransform());
    const QRectF view(bench.view.viewport()->rect());
    const std::vector<GuideLabel> labels = guideLabels(shown, camera, bench.theme, view);
    QCOMPARE(labels.size(), 1U);
    const std::vector<QLineF> strokes = explainingStrokes(shown, camera, bench.theme);
    QCOMPARE(strokes.size(), 1U);
    QVERIFY(strokes[0].length() > 100.0);
    QCOMPARE(lengthWithin(strokes[0], labels[0].box), 0.0);
}

void SceneDrawingTest::whatABoxCoversOfALine_data()
{
    QTest::addColumn<QLineF>("line");
    QTest::addColumn<double>("covered");
    QTest::newRow("through the middle") << QLineF(-5, 2, 20, 2) << 10.0;
    QTest::newRow("beside") << QLineF(-5, 5, 20, 5) << 0.0;
    QTest::newRow("within") << QLineF(8, 1, 5, 1) << 3.0;
    QTest::newRow("ends inside") << QLineF(5, -3, 5, 1) << 1.0;
    QTest::newRow("corner to corner") << QLineF(0, 0, 10, 4) << std::sqrt(116.0);
    QTest::newRow("past a corner") << QLineF(-2, 1, 1, -2) << 0.0;
}

void SceneDrawingTest::whatABoxCoversOfALine()
{
    QFETCH(QLineF, line);
    QFETCH(double, covered);
    QVERIFY(std::abs(lengthWithin(line, QRectF(0, 0, 10, 4)) - covered) < 1e-12);
}

void SceneDrawingTest::aThemeChangeRepaints()
{
    SceneBench bench;
    QCOMPARE(bench.image().pixelColor(2, 2), bench.theme.tokens().scene);
    bench.theme.setScheme(Scheme::dark);
    QCOMPARE(bench.image().pixelColor(2, 2), QColor("#131518"));
}

void SceneDrawingTest::namesAndNumbersAreReadable_data()
{
    QTest::addColumn<QString>("shown");
    QTest::addColumn<QString>("expected");
    QTest::newRow("a numbered foot") << bodyTitle("foot12") << "foot 12";
    QTest::newRow("a foot of one of several") << bodyTitle("creature1.foot0") << "creature 1, foot 0";
    QTest::newRow("a letter") << bodyTitle("p12") << "p12";
    QTest::newRow("a link of a tentacle") << bodyTitle("tentacle2_5") << "tentacle 2, 5";
    QTest::newRow("minus") << fixedNumber(-3.26, 1) << "−3.3";
    QTest::newRow("no minus nought") << fixedNumber(-0.01, 1) << "0.0";
    QTest::newRow("almost nothing") << shownMagnitude(0.0004) << "< 0.01";
    QTest::newRow("nothing") << shownMagnitude(0.0) << "0.00";
    QTest::newRow("at rest") << bodySentence("foot0", {310, 240}, {0.01, 0})
                             << "foot 0 at (310, 240), at rest";
    QTest::newRow("moving") << bodySentence("foot0", {310, -240}, {0, 2.3})
                            << "foot 0 at (310, −240), moving 2.3 px a frame";
    QTest::newRow("as far as numbers reach")
        << bodySentence("foot0", {1.7e308, -2e200}, {1e308, -1e308})
        << "foot 0 at (1.7·10³⁰⁸, −2·10²⁰⁰), moving 1.4·10³⁰⁸ px a frame";
    QTest::newRow("faster than numbers reach") << bodySentence("foot0", {0, 0}, {1.7e308, 1.7e308})
                                               << "foot 0 at (0, 0), moving 1.8·10³⁰⁸ px a frame";
}

void SceneDrawingTest::namesAndNumbersAreReadable()
{
    QFETCH(QString, shown);
    QFETCH(QString, expected);
    QCOMPARE(shown, expected);
}

void SceneDrawingTest::paintingTakesLittleTime()
{
    SceneBench bench("room");
    for (int i = 0; i < 30; ++i)
        bench.session.frameForward();
    QImage image(600, 470, QImage::Format_RGB32);
    bench.view.viewport()->render(&image);
    constexpr int times = 200;
    const std::clock_t start = std::clock();
    for (int i = 0; i < times; ++i)
        bench.view.viewport()->render(&image);
    const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / times;
    qInfo("painting 600 x 470 px takes %.2f ms of processor time", ms);
    QCOMPARE(image.pixelColor(598, 468), bench.theme.tokens().win); // the ground, so something was painted
}

QTEST_MAIN(SceneDrawingTest)
#include "tst_scene_drawing.moc"
