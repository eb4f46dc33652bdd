// The drawing and the captions of the scene view.

#include "app/model/picture/rest_marks.h"
#include "app/ui/scene/drawing/arrows.h"
#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/springs/springs.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QSettings>
#include <QtTest>

#include <cmath>
#include <ctime>

using namespace app;

class SceneDrawingTest : public QObject
{
    Q_OBJECT

private slots:
    void captionsSayWhatIsDone_data();
    void captionsSayWhatIsDone();
    void theCaptionNamesWhatHasMovedPoints();
    void pullsAreDrawnInsideAFrameOnly();
    void eachExtraChangesThePicture_data();
    void eachExtraChangesThePicture();
    void dampingShortensTheArrowOfTheVelocity();
    void velocitiesShowInsideAFrameUnlessTheyAreHidden();
    void aScaleStaysWhileArrowsFit();
    void changeOfTheScaleIsShownForAWhile();
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
        << "Inside frame 2: pulls change the velocities directly, nothing has moved yet.";
    QTest::newRow("published, feet moved")
        << published << 1.0 << 4 << "Inside frame 2: already moved: feet; not yet moved: body.";
    QTest::newRow("being added up")
        << simultaneous << 1.0 << 2
        << "Inside frame 2: accelerations are being added up, nothing has moved yet.";
    QTest::newRow("kicked") << simultaneous << 1.0 << 3
                            << "Inside frame 2: velocities have changed, nothing has moved yet.";
    QTest::newRow("second step of two")
        << simultaneous << 0.5 << 7
        << "Inside frame 2, step 2 of 2: accelerations are being added up, nothing has moved in it yet.";
    QTest::newRow("moved, walls to come")
        << simultaneous << 1.0 << 5 << "Inside frame 2: everything has moved; next: walls.";
    QTest::newRow("one step of two") << simultaneous << 0.5 << 6 << "Inside frame 2: 1 of 2 steps are done.";
}

void SceneDrawingTest::captionsSayWhatIsDone()
{
    QFETCH(QString, method);
    QFETCH(double, h);
    QFETCH(int, phase);
    QFETCH(QString, caption);
    SceneFixture fixture("room");
    fixture.session.editor().setMethod(method);
    fixture.session.editor().setStepSize(h);
    fixture.session.playback().goTo({2, phase});
    QCOMPARE(fixture.view.caption(), caption);
}

void SceneDrawingTest::theCaptionNamesWhatHasMovedPoints()
{
    QSettings().setValue("code/page", "engine"); // a key goes to the next phase, and not to the next line
    tests::WindowFixture fixture({.lesson = "rigid_constraint", .step = "pair"});
    QSettings().remove("code/page");
    QTest::mousePress(fixture.view.viewport(), Qt::LeftButton, {}, fixture.onScreen("p0") + QPoint(80, 40));
    fixture.key(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(fixture.view.caption(),
             QString("Inside frame 0: after pointer, points have moved directly, without a velocity."));
}

void SceneDrawingTest::pullsAreDrawnInsideAFrameOnly()
{
    SceneFixture fixture;
    fixture.session.editor().setMethod("semi_implicit_euler");
    const QColor spring = fixture.theme.tokens().spring;
    const QColor gravity = fixture.theme.tokens().gravity;
    QCOMPARE(fixture.pixels(spring), 0);
    fixture.session.playback().phaseForward();
    QVERIFY(fixture.pixels(spring) > 60);
    QCOMPARE(fixture.pixels(gravity), 0);
    fixture.session.playback().phaseForward();
    QVERIFY(fixture.pixels(gravity) > 60);
    fixture.goTo(1);
    QCOMPARE(fixture.pixels(spring) + fixture.pixels(gravity), 0);
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
    SceneFixture fixture(extra == 3 ? "lone" : "creature");
    for (int i = 0; i < 12; ++i)
        fixture.session.playback().frameForward();
    if (extra == 5) {
        fixture.goTo(4);
        fixture.session.editor().setParameter("gravity", 1.4);
        fixture.goTo(12);
    }
    const QImage before = fixture.image();
    bool Extras::*const members[] = {&Extras::trails,   &Extras::velocities, &Extras::grid,
                                     &Extras::overlays, &Extras::eyes,       &Extras::comparison};
    Extras extras = fixture.view.extras();
    extras.*members[extra] = !(extras.*members[extra]);
    fixture.view.setExtras(extras);
    QVERIFY(fixture.image() != before);
    fixture.view.setExtras(Extras());
    QVERIFY(fixture.image() == before);
}

namespace {

double lengthOf(QPointF way)
{
    return std::hypot(way.x(), way.y());
}

/// The arrows of one foot on a spring.
std::vector<Arrow> velocitiesOf(const SceneFixture &fixture)
{
    return velocityArrows(fixture.view.shown(), Camera(fixture.view.viewportTransform()), fixture.theme);
}

/// A foot on a spring, which is damped by a tenth a frame.
lessons::Step dampedFoot()
{
    lessons::Step step = drawn_scenes::step("damped", {}, {});
    step.method = "semi_implicit_euler";
    step.scene = [](const sim::Values &) { return scenes::oscillator({400, 200}, {270, 200}, 0.05, 0.8); };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    return step;
}

}

void SceneDrawingTest::dampingShortensTheArrowOfTheVelocity()
{
    SceneFixture fixture({dampedFoot()});
    const auto &pipeline = fixture.session.timeline().track().interval().pipeline;
    int damping = 0;
    while (pipeline.phaseAt(damping).title.find("damping") == std::string::npos)
        ++damping;
    fixture.session.playback().goTo({3, damping});
    const std::vector<Arrow> before = velocitiesOf(fixture);
    const QImage without = fixture.image();
    fixture.session.playback().goTo({3, damping + 1});
    const std::vector<Arrow> after = velocitiesOf(fixture);
    QVERIFY(fixture.image() != without);
    QCOMPARE(after.size(), std::size_t{2}); // what it was, and what it is
    QVERIFY(std::abs(lengthOf(after[0].vector) - lengthOf(before.back().vector)) < 1e-9);
    QVERIFY(std::abs(lengthOf(after[1].vector) - 0.8 * lengthOf(after[0].vector)) < 1e-9);
    QVERIFY(lengthOf(after[0].vector) - lengthOf(after[1].vector) > 4.0); // px of the screen: it is seen
    QVERIFY(after[0].style.color.alphaF() < after[1].style.color.alphaF());
}

void SceneDrawingTest::velocitiesShowInsideAFrameUnlessTheyAreHidden()
{
    SceneFixture fixture({dampedFoot()});
    fixture.goTo(3);
    QVERIFY(velocitiesOf(fixture).empty());
    fixture.session.playback().goTo({3, 1});
    QVERIFY(!velocitiesOf(fixture).empty());
    Extras extras = fixture.view.extras();
    extras.velocities = true;
    fixture.view.setExtras(extras);
    extras.velocities = false; // the learner's choice from here on
    fixture.view.setExtras(extras);
    fixture.session.playback().goTo({3, 2});
    QVERIFY(velocitiesOf(fixture).empty());
}

namespace {

/// One foot that goes so fast.
SceneContent shownAt(const SceneFixture &fixture, double speed)
{
    SceneContent shown;
    shown.picture = fixture.session.presentation().picture();
    shown.picture.state.velocity.row(0) << speed, 0.0;
    shown.extras.velocities = true;
    return shown;
}

}

void SceneDrawingTest::aScaleStaysWhileArrowsFit()
{
    const SceneFixture fixture("lone");
    SceneContent shown = shownAt(fixture, 10.0);
    measureArrows(shown, 0);
    const double unit = shown.scales.velocity.unit;
    for (const double speed : {8.0, 5.0, 3.0, 10.0, 4.0}) {
        shown.picture.state.velocity.row(0) << speed, 0.0;
        measureArrows(shown, 1);
        QCOMPARE(shown.scales.velocity.unit, unit);
        QVERIFY(!shown.scales.velocity.before);
    }
}

void SceneDrawingTest::changeOfTheScaleIsShownForAWhile()
{
    const SceneFixture fixture("lone");
    SceneContent shown = shownAt(fixture, 10.0);
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
    SceneFixture fixture({step});
    fixture.session.playback().goTo({3, 1});
    const QImage image = fixture.image();
    int clean = 0;
    const QRect row(0, image.height() - 30, image.width(), 20);
    for (int x = row.left(); x <= row.right(); ++x) {
        int strong = 0; // px that only lines have
        for (int y = row.top(); y <= row.bottom(); ++y)
            strong += image.pixelColor(x, y) == fixture.theme.tokens().ink2 ? 1 : 0;
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
        lessons::View view = drawn_scenes::feetOnly(scene);
        view.bodies[0].radius = 15.0;
        view.ground = 315.0;
        SceneFixture fixture({drawn_scenes::step("shadow", scene, view)});
        fixture.theme.setScheme(static_cast<Scheme>(scheme));
        fixture.session.select({}); // no ring round it
        fixture.view.fit();         // the same picture, wherever the disc is
        const QPoint at = fixture.view.mapFromScene(150.0, 315.0);
        int sum = 0; // of the lightness of the floor just below the disc
        const QImage image = fixture.image();
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

/// Contrast as in WCAG 2.1, which requires 3 for essential graphics. The grid is less important, so it is fainter.
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
    lessons::Step step = drawn_scenes::step("pressed", {}, {});
    step.scene = [](const sim::Values &) {
        sim::Scene scene = scenes::pointsAt({{160, 200}, {100, 200}});
        scene.start.inverseMass[1] = 0.0;
        scene.effects.push_back(
            std::make_shared<sim::Springs>(std::vector<sim::Spring>{{0, 1, 0.2, 100.0}}, 2));
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return drawn_scenes::feetOnly(scene); };
    return step;
}

}

void SceneDrawingTest::aBarMarksTheLengthAtRest()
{
    SceneFixture fixture({pressedSpring()});
    const std::vector<RestMark> marks =
        restMarks(fixture.session.presentation().picture().interval->scene,
                  fixture.session.presentation().picture().state, fixture.view.shown().view());
    QCOMPARE(marks.size(), std::size_t{1});
    QCOMPARE(marks[0].rest.mover, 0); // the end that can go
    QVERIFY(sim::length(marks[0].rest.position - sim::Vec2{200, 200}) < 1e-9);
    Extras extras = fixture.view.extras();
    extras.grid = extras.overlays = false;
    fixture.view.setExtras(extras);
    const QColor spring = fixture.theme.tokens().spring;
    QCOMPARE(fixture.pixels(spring), 0);
    extras.rests = true;
    fixture.view.setExtras(extras);
    const QPoint bar = fixture.view.mapFromScene(200.0, 200.0);
    const QImage image = fixture.image();
    int onBar = 0;
    for (int y = bar.y() - 5; y <= bar.y() + 5; ++y) {
        for (int x = bar.x() - 1; x <= bar.x() + 1; ++x)
            onBar += image.pixelColor(x, y) == spring ? 1 : 0;
    }
    QVERIFY2(onBar >= 8, qPrintable(QString::number(onBar)));
}

void SceneDrawingTest::nothingOfRestLengthsIsDrawnWhileTheyAreOff()
{
    SceneFixture fixture({pressedSpring()});
    const QImage off = fixture.image();
    Extras extras = fixture.view.extras();
    extras.rests = true;
    fixture.view.setExtras(extras);
    QVERIFY(fixture.image() != off);
    extras.rests = false;
    fixture.view.setExtras(extras);
    QVERIFY(fixture.image() == off);
}

void SceneDrawingTest::aGhostIsDrawnWhereItDiffers()
{
    SceneFixture fixture;
    fixture.goTo(12);
    fixture.goTo(4);
    const QImage before = fixture.image();
    fixture.session.editor().setParameter("gravity", 1.4);
    QVERIFY(fixture.session.presentation().comparison().has_value());
    QVERIFY2(fixture.image() == before, "where both runs are the same there is nothing to see");
    fixture.goTo(12);
    const QImage with = fixture.image();
    fixture.session.comparisons().removeShown();
    QVERIFY(fixture.image() != with);
}

void SceneDrawingTest::theTrailFollowsForwardOnly()
{
    SceneFixture fixture;
    Trail trail;
    const auto at = [&](sim::Cursor cursor) {
        fixture.session.playback().goTo(cursor);
        trail.follow(fixture.session.timeline());
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
    fixture.session.editor().setStepSize(0.5);
    QCOMPARE(at({129, 0}), 1); // another run
}

void SceneDrawingTest::aThemeChangeRepaints()
{
    SceneFixture fixture;
    QCOMPARE(fixture.image().pixelColor(2, 2), fixture.theme.tokens().scene);
    fixture.theme.setScheme(Scheme::dark);
    QCOMPARE(fixture.image().pixelColor(2, 2), QColor("#131518"));
}

void SceneDrawingTest::paintingTakesLittleTime()
{
    SceneFixture fixture("room");
    for (int i = 0; i < 30; ++i)
        fixture.session.playback().frameForward();
    QImage image(600, 470, QImage::Format_RGB32);
    fixture.view.viewport()->render(&image);
    constexpr int times = 200;
    const std::clock_t start = std::clock();
    for (int i = 0; i < times; ++i)
        fixture.view.viewport()->render(&image);
    const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / times;
    qInfo("painting 600 x 470 px takes %.2f ms of processor time", ms);
    QCOMPARE(image.pixelColor(598, 468), fixture.theme.tokens().win); // the ground, so something was painted
}

SUITE(tst_scene_drawing, SceneDrawingTest)
#include "tst_scene_drawing.moc"
