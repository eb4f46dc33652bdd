// What the scene view draws and says.

#include "app/model/rest_marks.h"
#include "app/ui/scene/arrows.h"
#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "look_scenes.h"
#include "scene_bench.h"
#include "sim/effects/springs/springs.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <ctime>

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
    void dampingShortensTheArrowOfTheVelocity();
    void velocitiesShowInsideAFrameUnlessTheyAreHidden();
    void aScaleStaysWhileArrowsFit();
    void aChangeOfTheScaleIsSaid();
    void noArrowRunsThroughTheLegend();
    void aDiscThrowsAShadowOnTheFloor_data();
    void aDiscThrowsAShadowOnTheFloor();
    void theGridIsSeen_data();
    void theGridIsSeen();
    void aBarMarksTheLengthAtRest();
    void nothingOfRestLengthsIsDrawnWhileTheyAreOff();
    void aGhostIsDrawnWhereItDiffers();
    void theTrailFollowsForwardOnly();
    void aThemeChangeRepaints();
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

double lengthOf(QPointF way)
{
    return std::hypot(way.x(), way.y());
}

/// The arrows of one foot on a spring.
std::vector<Arrow> velocitiesOf(const SceneBench &bench)
{
    return velocityArrows(bench.view.shown(), Camera(bench.view.viewportTransform()), bench.theme);
}

/// A foot on a spring, which is damped by a tenth a frame.
lessons::Step dampedFoot()
{
    lessons::Step step = look_scenes::step("damped", {}, {});
    step.method = "semi_implicit_euler";
    step.scene = [](const sim::Values &) { return scenes::oscillator({400, 200}, {270, 200}, 0.05, 0.8); };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    return step;
}

}

void SceneDrawingTest::dampingShortensTheArrowOfTheVelocity()
{
    SceneBench bench({dampedFoot()});
    const auto &pipeline = bench.session.timeline().track().interval().pipeline;
    int damping = 0;
    while (pipeline.phaseAt(damping).title.find("damping") == std::string::npos)
        ++damping;
    bench.session.goTo({3, damping});
    const std::vector<Arrow> before = velocitiesOf(bench);
    const QImage without = bench.image();
    bench.session.goTo({3, damping + 1});
    const std::vector<Arrow> after = velocitiesOf(bench);
    QVERIFY(bench.image() != without);
    QCOMPARE(after.size(), std::size_t{2}); // what it was, and what it is
    QVERIFY(std::abs(lengthOf(after[0].vector) - lengthOf(before.back().vector)) < 1e-9);
    QVERIFY(std::abs(lengthOf(after[1].vector) - 0.8 * lengthOf(after[0].vector)) < 1e-9);
    QVERIFY(lengthOf(after[0].vector) - lengthOf(after[1].vector) > 4.0); // px of the screen: it is seen
    QVERIFY(after[0].style.color.alphaF() < after[1].style.color.alphaF());
}

void SceneDrawingTest::velocitiesShowInsideAFrameUnlessTheyAreHidden()
{
    SceneBench bench({dampedFoot()});
    bench.session.goTo({3, 0});
    QVERIFY(velocitiesOf(bench).empty());
    bench.session.goTo({3, 1});
    QVERIFY(!velocitiesOf(bench).empty());
    Extras extras = bench.view.extras();
    extras.velocities = true;
    bench.view.setExtras(extras);
    extras.velocities = false; // the learner's choice from here on
    bench.view.setExtras(extras);
    bench.session.goTo({3, 2});
    QVERIFY(velocitiesOf(bench).empty());
}

namespace {

/// One foot that goes so fast.
Shown shownAt(const SceneBench &bench, double speed)
{
    Shown shown;
    shown.picture = bench.session.picture();
    shown.picture.state.velocity.row(0) << speed, 0.0;
    shown.extras.velocities = true;
    return shown;
}

}

void SceneDrawingTest::aScaleStaysWhileArrowsFit()
{
    const SceneBench bench("lone");
    Shown shown = shownAt(bench, 10.0);
    measureArrows(shown, 0);
    const double unit = shown.scales.velocity.unit;
    for (const double speed : {8.0, 5.0, 3.0, 10.0, 4.0}) {
        shown.picture.state.velocity.row(0) << speed, 0.0;
        measureArrows(shown, 1);
        QCOMPARE(shown.scales.velocity.unit, unit);
        QVERIFY(!shown.scales.velocity.before);
    }
}

void SceneDrawingTest::aChangeOfTheScaleIsSaid()
{
    const SceneBench bench("lone");
    Shown shown = shownAt(bench, 10.0);
    measureArrows(shown, 0);
    QVERIFY2(!shown.scales.velocity.before, "the first scale is no change");
    const double unit = shown.scales.velocity.unit;
    shown.picture.state.velocity.row(0) << 1000.0, 0.0;
    measureArrows(shown, 40);
    QVERIFY(shown.scales.velocity.unit > unit);
    QCOMPARE(shown.scales.velocity.before, std::optional(unit));
    measureArrows(shown, 50); // it can still be read
    QCOMPARE(shown.scales.velocity.before, std::optional(unit));
    measureArrows(shown, 100);
    QVERIFY(!shown.scales.velocity.before);
}

void SceneDrawingTest::noArrowRunsThroughTheLegend()
{
    lessons::Step step = dampedFoot();
    step.overlays = [](const sim::Scene &, const sim::State &, const sim::Values &) {
        // A wide line along the row of the legend, at whatever height that is.
        std::vector<lessons::Overlay> lines;
        for (double y = 300.0; y < 500.0; y += 0.5)
            lines.push_back({.shape = lessons::Overlay::Shape::line, .a = {0, y}, .b = {1000, y}});
        return lines;
    };
    SceneBench bench({step});
    bench.session.goTo({3, 1});
    const QImage image = bench.image();
    int clean = 0;
    const QRect row(0, image.height() - 30, image.width(), 20);
    for (int x = row.left(); x <= row.right(); ++x) {
        int strong = 0; // px that only lines have
        for (int y = row.top(); y <= row.bottom(); ++y)
            strong += image.pixelColor(x, y) == bench.theme.tokens().ink2 ? 1 : 0;
        clean += strong == 0 ? 1 : 0;
    }
    QVERIFY2(clean > 150, qPrintable(QString::number(clean))); // as wide as the legend at least
}

void SceneDrawingTest::aDiscThrowsAShadowOnTheFloor_data()
{
    QTest::addColumn<int>("scheme");
    QTest::addColumn<bool>("hasShadow");
    QTest::newRow("light") << static_cast<int>(Scheme::light) << true;
    QTest::newRow("dark") << static_cast<int>(Scheme::dark) << true;
    QTest::newRow("high contrast") << static_cast<int>(Scheme::highContrast) << false;
}

void SceneDrawingTest::aDiscThrowsAShadowOnTheFloor()
{
    QFETCH(int, scheme);
    QFETCH(bool, hasShadow);
    const auto floorUnder = [&](double height) {
        const sim::Scene scene = scenes::pointsAt({{150, 300.0 - height}});
        lessons::View look = look_scenes::feetOnly(scene);
        look.bodies[0].radius = 15.0;
        look.ground = 315.0;
        SceneBench bench({look_scenes::step("shadow", scene, look)});
        bench.theme.setScheme(static_cast<Scheme>(scheme));
        bench.session.select({}); // no ring round it
        bench.view.fit();         // the same picture, wherever the disc is
        const QPoint at = bench.view.mapFromScene(150.0, 315.0);
        int sum = 0; // of the lightness of the floor just below the disc
        const QImage image = bench.image();
        for (int x = -8; x <= 8; ++x) {
            for (int y = 3; y <= 6; ++y)
                sum += qGray(image.pixel(at + QPoint(x, y)));
        }
        return sum;
    };
    const int onFloor = floorUnder(0.0), low = floorUnder(60.0), high = floorUnder(250.0);
    if (hasShadow)
        QVERIFY2(onFloor < low && low < high,
                 qPrintable(QString("%1 %2 %3").arg(onFloor).arg(low).arg(high)));
    else
        QVERIFY(onFloor == low && low == high);
}

void SceneDrawingTest::theGridIsSeen_data()
{
    QTest::addColumn<int>("scheme");
    QTest::newRow("light") << static_cast<int>(Scheme::light);
    QTest::newRow("dark") << static_cast<int>(Scheme::dark);
    QTest::newRow("high contrast") << static_cast<int>(Scheme::highContrast);
}

/// Contrast as WCAG 2.1 has it. 3 is for what one must see; the grid must be seen without getting in the way.
void SceneDrawingTest::theGridIsSeen()
{
    QFETCH(int, scheme);
    const Theme theme(static_cast<Scheme>(scheme));
    const auto luminance = [](const QColor &color) {
        const auto linear = [](double c) {
            return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
               0.0722 * linear(color.blueF());
    };
    const double a = luminance(theme.tokens().dots), b = luminance(theme.tokens().scene);
    const double contrast = (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
    QVERIFY2(contrast > 1.4 && contrast < 3.0, qPrintable(QString::number(contrast)));
}

namespace {

/// A spring, 100 px long at rest, from a body that stands at (100, 200) to a foot 60 px to its right.
lessons::Step pressedSpring()
{
    lessons::Step step = look_scenes::step("pressed", {}, {});
    step.scene = [](const sim::Values &) {
        sim::Scene scene = scenes::pointsAt({{160, 200}, {100, 200}});
        scene.start.inverseMass[1] = 0.0;
        scene.effects.push_back(
            std::make_shared<sim::Springs>(std::vector<sim::Spring>{{0, 1, 0.2, 100.0}}, 2));
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return look_scenes::feetOnly(scene); };
    return step;
}

}

void SceneDrawingTest::aBarMarksTheLengthAtRest()
{
    SceneBench bench({pressedSpring()});
    const std::vector<RestMark> marks = restMarks(bench.session.picture().interval->scene,
                                                  bench.session.picture().state, bench.view.shown().look());
    QCOMPARE(marks.size(), std::size_t{1});
    QCOMPARE(marks[0].rest.mover, 0); // the end that can go
    QVERIFY(sim::length(marks[0].rest.position - sim::Vec2{200, 200}) < 1e-9);
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

void SceneDrawingTest::aThemeChangeRepaints()
{
    SceneBench bench;
    QCOMPARE(bench.image().pixelColor(2, 2), bench.theme.tokens().scene);
    bench.theme.setScheme(Scheme::dark);
    QCOMPARE(bench.image().pixelColor(2, 2), QColor("#131518"));
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
