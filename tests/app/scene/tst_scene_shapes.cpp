// The shapes of a view, as they are drawn: legs, sticks, skins, tentacles, hidden bodies.

#include "app/ui/scene/layers/sticks.h"
#include "lessons/api/view/view.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QtTest>

#include <cmath>

using namespace app;
using lessons::View;
using Shape = lessons::BodyView::Shape;

namespace {

QPoint pixelAt(const SceneFixture &fixture, sim::Vec2 place)
{
    return fixture.view.viewportTransform().map(QPointF(place.x, place.y)).toPoint();
}

bool isPaper(const SceneFixture &fixture, const QImage &image, QPoint at)
{
    return image.pixelColor(at) == fixture.theme.tokens().scene;
}

/// How many px of the column (or, `down`, of the row) through `at` have a colour that is not the paper's.
int thickness(const SceneFixture &fixture, const QImage &image, QPoint at, QPoint step)
{
    int count = isPaper(fixture, image, at) ? 0 : 1;
    for (const int side : {-1, 1}) {
        for (QPoint p = at + side * step; image.rect().contains(p) && !isPaper(fixture, image, p);
             p += side * step)
            ++count;
    }
    return count;
}

lessons::View withoutGridOrDiscs(const sim::Scene &scene)
{
    View view = drawn_scenes::feetOnly(scene);
    for (lessons::BodyView &body : view.bodies)
        body.shape = Shape::none;
    return view;
}

void hideTheGrid(SceneFixture &fixture)
{
    Extras extras = fixture.view.extras();
    extras.grid = false;
    fixture.view.setExtras(extras);
}

/// Whether a pixel has the colour of `ink`, or at the edge of a fine line three quarters of it.
bool isInk(const QColor &pixel, const QColor &ink)
{
    const int off = std::abs(pixel.red() - ink.red()) + std::abs(pixel.green() - ink.green()) +
                    std::abs(pixel.blue() - ink.blue());
    const int paper = 3 * 255 - ink.red() - ink.green() - ink.blue();
    return 4 * off < paper;
}

}

class SceneShapesTest : public QObject
{
    Q_OBJECT

private slots:
    void aLegBendsAsItsControlPointSays_data();
    void aLegBendsAsItsControlPointSays();
    void aGhostsLegBendsToo();
    void aStickHasTheColourOfItsError_data();
    void aStickHasTheColourOfItsError();
    void aStretchedStickGetsThinner();
    void aSpringKeepsItsTurnsAndShowsItsStretch();
    void aSpringToAPlaceEndsThere();
    void aGhostsSpringToAPlaceIsDrawn();
    void softMatterIsFilledAndFine();
    void aLegIsThickAtTheBodyAndThinAtTheFoot();
    void aLimbIsAsWideAsItSays();
    void aJointIsAHollowDisc();
    void aHiddenBodyIsNotDrawn();
    void aSkinGoesThroughItsPoints();
    void aSkinLooksWhereItGoes();
    void aTentacleGetsThinner();
    void windStandsStillWithTime();
};

void SceneShapesTest::aLegBendsAsItsControlPointSays_data()
{
    QTest::addColumn<double>("curve");
    QTest::newRow("straight") << 0.0;
    QTest::newRow("bent up") << 60.0;
    QTest::newRow("bent far up") << 120.0;
}

void SceneShapesTest::aLegBendsAsItsControlPointSays()
{
    QFETCH(double, curve);
    const sim::Vec2 body{210, 220};
    const sim::Vec2 foot{330, 260};
    const sim::Scene scene = scenes::pointsAt({body, foot});
    View view = withoutGridOrDiscs(scene);
    view.legs.push_back({0, 1, curve});
    SceneFixture fixture({drawn_scenes::step("leg", scene, view)});
    hideTheGrid(fixture);
    const QImage image = fixture.image();
    // B(1/2) = (body + 2 control + foot) / 4
    const sim::Vec2 middle = 0.25 * (body + 2.0 * (foot - sim::Vec2{0, curve}) + foot);
    const sim::Vec2 straight = 0.5 * (body + foot);
    QVERIFY(!isPaper(fixture, image, pixelAt(fixture, curve > 0.0 ? middle : straight)));
    QCOMPARE(isPaper(fixture, image, pixelAt(fixture, straight)), curve > 0.0);
}

void SceneShapesTest::aGhostsLegBendsToo()
{
    sim::Scene scene = scenes::pointsAt({{210, 220}, {330, 260}});
    drawn_scenes::letGlide(scene, {0.0, 1.0});
    View view = drawn_scenes::feetOnly(scene);
    view.legs.push_back({0, 1, 80.0});
    SceneFixture fixture({drawn_scenes::step("leg", scene, view)});
    hideTheGrid(fixture);
    fixture.goTo(10);
    fixture.goTo(2);
    for (const char *body : {"p0", "p1"}) {
        fixture.session.input().grab(body);
        fixture.session.input().moveTo({270, 330});
        fixture.session.input().release();
    }
    fixture.goTo(10);
    QVERIFY(fixture.session.presentation().comparison().has_value());
    const QImage image = fixture.image();
    const sim::Vec2 middle{0.25 * (210 + 3 * 330), 10 + 0.25 * (220 + 2 * 180 + 260)};
    const QPoint at = pixelAt(fixture, middle);
    int inked = 0; // dashes: some of the px near by are, some are not
    for (int x = -6; x <= 6; ++x) {
        for (int y = -6; y <= 6; ++y)
            inked += isPaper(fixture, image, at + QPoint(x, y)) ? 0 : 1;
    }
    QVERIFY(inked > 8 && inked < 90);
}

void SceneShapesTest::aStickHasTheColourOfItsError_data()
{
    QTest::addColumn<double>("error");
    QTest::addColumn<QString>("expected");
    QTest::newRow("exact") << 0.0 << "stick";
    QTest::newRow("half a percent too long") << 0.005 << "stick";
    QTest::newRow("half a percent too short") << -0.005 << "stick";
    QTest::newRow("halfway to 20 %") << 0.105 << "near";
    QTest::newRow("20 % too long") << 0.2 << "past";
    QTest::newRow("20 % too short") << -0.2 << "past";
    QTest::newRow("far too long") << 1.5 << "past";
}

void SceneShapesTest::aStickHasTheColourOfItsError()
{
    QFETCH(double, error);
    QFETCH(QString, expected);
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
    View view = withoutGridOrDiscs(scene);
    view.sticks.push_back({0, 1, 160.0 / (1.0 + error), 6.0});
    SceneFixture fixture({drawn_scenes::step("stick", scene, view)});
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        fixture.theme.setScheme(scheme);
        const Tokens &t = fixture.theme.tokens();
        const QColor color = expected == "stick" ? t.stick : expected == "near" ? t.near : t.past;
        QCOMPARE(fixture.image().pixelColor(pixelAt(fixture, {270, 200})), color);
    }
}

void SceneShapesTest::aStretchedStickGetsThinner()
{
    const auto width = [](double error) {
        const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
        View view = withoutGridOrDiscs(scene);
        view.sticks.push_back({0, 1, 160.0 / (1.0 + error), 6.0});
        SceneFixture fixture({drawn_scenes::step("stick", scene, view)});
        hideTheGrid(fixture);
        return thickness(fixture, fixture.image(), pixelAt(fixture, {270, 200}), {0, 1});
    };
    const int wanted = width(0.0);
    QVERIFY(wanted >= 10);
    QVERIFY(width(0.2) <= 0.7 * wanted);
    QVERIFY(width(-0.2) >= 1.4 * wanted);
}

namespace {

/// A spring as it is drawn from (150, 200) to the right.
struct DrawnSpring
{
    int crossings = 0; ///< of its strands with the line from end to end
    int height = 0;    ///< px of the screen
};

DrawnSpring drawnSpring(double length, double rest)
{
    const sim::Scene scene = scenes::pointsAt({{150, 200}, {150 + length, 200}});
    View view = withoutGridOrDiscs(scene);
    view.springs.push_back({0, 1, rest});
    SceneFixture fixture({drawn_scenes::step("spring", scene, view)});
    hideTheGrid(fixture);
    const QImage image = fixture.image();
    // Without the straight ends.
    const QPoint from = pixelAt(fixture, {150 + 0.15 * length, 200});
    const QPoint to = pixelAt(fixture, {150 + 0.85 * length, 200});
    DrawnSpring drawn;
    bool wasInked = true;
    int top = from.y(), bottom = from.y();
    for (int x = from.x(); x <= to.x(); ++x) {
        const bool isInked = !isPaper(fixture, image, {x, from.y()});
        drawn.crossings += isInked && !wasInked ? 1 : 0;
        wasInked = isInked;
        for (int y = from.y() - 40; y <= from.y() + 40; ++y) {
            if (isPaper(fixture, image, {x, y}))
                continue;
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    }
    drawn.height = bottom - top;
    return drawn;
}

}

void SceneShapesTest::aSpringKeepsItsTurnsAndShowsItsStretch()
{
    const DrawnSpring pressed = drawnSpring(80.0, 120.0);
    const DrawnSpring atRest = drawnSpring(120.0, 120.0);
    const DrawnSpring stretched = drawnSpring(240.0, 120.0);
    QVERIFY(atRest.crossings > 10);
    QVERIFY(std::abs(stretched.crossings - atRest.crossings) <= 2); // the ends of the count
    QVERIFY(std::abs(pressed.crossings - atRest.crossings) <= 2);
    QVERIFY(pressed.height > atRest.height + 1);
    QVERIFY(stretched.height < atRest.height - 2);
}

void SceneShapesTest::aSpringToAPlaceEndsThere()
{
    sim::Scene scene = scenes::pointsAt({{210, 200}});
    drawn_scenes::letGlide(scene, {0.0, 4.0});
    View view = withoutGridOrDiscs(scene);
    view.springs.push_back({0, -1, 0.0, {290, 200}});
    SceneFixture fixture({drawn_scenes::step("spring", scene, view)});
    hideTheGrid(fixture);
    const auto isSpring = [&](sim::Vec2 place) {
        const QImage image = fixture.image();
        const QPoint at = pixelAt(fixture, place);
        for (int x = -2; x <= 2; ++x) {
            for (int y = -2; y <= 2; ++y) {
                if (isInk(image.pixelColor(at + QPoint(x, y)), fixture.theme.tokens().spring))
                    return true;
            }
        }
        return false;
    };
    for (const int frame : {0, 10}) {
        fixture.goTo(frame);
        const sim::Vec2 from = fixture.place("p0"), way = sim::Vec2{290, 200} - from;
        QVERIFY(isSpring(from + 0.05 * way) && isSpring(from + 0.95 * way));
        const double beyond =
            10.0 / (fixture.view.transform().m11() * sim::length(way)); // 10 px of the screen
        QVERIFY(!isSpring(from - beyond * way) && !isSpring(from + (1.0 + beyond) * way));
    }
}

void SceneShapesTest::aGhostsSpringToAPlaceIsDrawn()
{
    sim::Scene scene = scenes::pointsAt({{210, 200}});
    drawn_scenes::letGlide(scene, {0.0, 4.0});
    View view = withoutGridOrDiscs(scene);
    view.bodies[0].shape = Shape::foot;
    view.springs.push_back({0, -1, 0.0, {290, 200}});
    SceneFixture fixture({drawn_scenes::step("spring", scene, view)});
    hideTheGrid(fixture);
    fixture.goTo(10);
    fixture.goTo(2);
    fixture.session.input().grab("p0");
    fixture.session.input().moveTo({210, 250});
    fixture.session.input().release();
    fixture.goTo(10);
    QVERIFY(fixture.session.presentation().comparison().has_value());
    const QImage image = fixture.image();
    int inked = 0; // along the way from where it was to the place
    for (int i = 20; i <= 80; ++i) {
        const double t = i / 100.0;
        inked += isPaper(fixture, image, pixelAt(fixture, {210 + 80 * t, 240 - 40 * t})) ? 0 : 1;
    }
    QVERIFY(inked > 15 && inked < 60); // dashes
}

void SceneShapesTest::softMatterIsFilledAndFine()
{
    const sim::Scene scene = scenes::pointsAt({{200, 150}, {340, 150}, {340, 250}, {200, 250}});
    View view = withoutGridOrDiscs(scene);
    view.sheets.push_back({{0, 1, 2, 3}});
    using Part = lessons::SpringView::Part;
    view.springs.push_back({0, 1, 140.0, {}, Part::edge});
    SceneFixture fixture({drawn_scenes::step("sheet", scene, view)});
    hideTheGrid(fixture);
    QImage image = fixture.image();
    QVERIFY(!isPaper(fixture, image, pixelAt(fixture, {270, 200})));
    QVERIFY(isPaper(fixture, image, pixelAt(fixture, {190, 200})));
    QVERIFY(isInk(image.pixelColor(pixelAt(fixture, {270, 150})), fixture.theme.tokens().spring));
    QVERIFY(isPaper(fixture, image, pixelAt(fixture, {270, 150}) - QPoint(0, 4))); // a line, no zigzag
    fixture.theme.setScheme(Scheme::highContrast);
    QVERIFY(isPaper(fixture, fixture.image(),
                    pixelAt(fixture, {270, 200}))); // nothing but black, white and kinds
}

void SceneShapesTest::aLegIsThickAtTheBodyAndThinAtTheFoot()
{
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
    for (const double curve : {0.0, 1.0}) {
        View view = withoutGridOrDiscs(scene);
        view.legs.push_back({0, 1, curve});
        SceneFixture fixture({drawn_scenes::step("leg", scene, view)});
        hideTheGrid(fixture);
        const QImage image = fixture.image();
        const int atBody = thickness(fixture, image, pixelAt(fixture, {200, 200}), {0, 1});
        const int atFoot = thickness(fixture, image, pixelAt(fixture, {340, 200}), {0, 1});
        QVERIFY(atFoot >= 1 && atBody > atFoot);
    }
}

void SceneShapesTest::aLimbIsAsWideAsItSays()
{
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
    View view = withoutGridOrDiscs(scene);
    view.limbs.push_back({0, 1, 20.0});
    SceneFixture fixture({drawn_scenes::step("limb", scene, view)});
    hideTheGrid(fixture);
    const QImage image = fixture.image();
    const double zoom = fixture.view.zoom() / 100.0;
    QVERIFY(std::abs(thickness(fixture, image, pixelAt(fixture, {270, 200}), {0, 1}) - 20.0 * zoom) < 3.0);
    QCOMPARE(image.pixelColor(pixelAt(fixture, {270, 200})), fixture.theme.tokens().body);
    // Round ends: it goes on for nearly half its width.
    QVERIFY(!isPaper(fixture, image, pixelAt(fixture, {350 + 9, 200})));
    QVERIFY(isPaper(fixture, image, pixelAt(fixture, {350 + 11.5, 200})));
    QVERIFY(isPaper(fixture, image, pixelAt(fixture, {350 + 9, 200 + 9})));
}

void SceneShapesTest::aJointIsAHollowDisc()
{
    const sim::Scene scene = scenes::pointsAt({{270, 200}, {320, 240}});
    View view = withoutGridOrDiscs(scene);
    view.bodies[0] = {Shape::joint, 6.0};
    SceneFixture fixture({drawn_scenes::step("joint", scene, view)});
    hideTheGrid(fixture);
    fixture.session.select("p1");
    const QImage image = fixture.image();
    QVERIFY(isPaper(fixture, image, pixelAt(fixture, {270, 200})));
    QCOMPARE(image.pixelColor(pixelAt(fixture, {275.2, 200})), fixture.theme.tokens().stick);
    fixture.press(pixelAt(fixture, {270, 200}));
    QCOMPARE(fixture.session.selected(), "p0");
}

void SceneShapesTest::aHiddenBodyIsNotDrawn()
{
    const sim::Scene scene = scenes::pointsAt({{270, 200}, {320, 240}});
    View view = withoutGridOrDiscs(scene);
    view.bodies[1].shape = Shape::foot;
    SceneFixture fixture({drawn_scenes::step("hidden", scene, view)});
    hideTheGrid(fixture);
    QCOMPARE(fixture.session.selected(), "p0"); // no ring, no name
    QVERIFY(fixture.pixels(fixture.theme.tokens().ink) == 0);
    QVERIFY(isPaper(fixture, fixture.image(), pixelAt(fixture, {270, 200})));
    // If both bodies are outside the picture, only the visible one has a sign at the edge.
    while (fixture.view.zoom() < 1500.0)
        fixture.wheel({20, 450}, {0, 120});
    QVERIFY(!fixture.view.viewport()->rect().contains(pixelAt(fixture, {270, 200})));
    QVERIFY(!fixture.view.viewport()->rect().contains(pixelAt(fixture, {320, 240})));
    Hud hud(fixture.view.shown(), fixture.view.companion(), fixture.theme);
    const auto markers = hud.markers(Camera(fixture.view.viewportTransform()), QRectF(0, 0, 600, 470));
    QCOMPARE(markers.size(), 1U);
    QCOMPARE(markers[0].bodies, 1);
    QCOMPARE(markers[0].point, 1);
}

void SceneShapesTest::aSkinGoesThroughItsPoints()
{
    const std::vector<sim::Vec2> corners{{210, 200}, {250, 150}, {320, 170}, {340, 220}, {280, 250}};
    const sim::Scene scene = scenes::pointsAt(corners);
    View view = withoutGridOrDiscs(scene);
    view.skins.push_back({{0, 1, 2, 3, 4}, -1});
    SceneFixture fixture({drawn_scenes::step("skin", scene, view)});
    hideTheGrid(fixture);
    const QImage image = fixture.image();
    const sim::Vec2 middle{280, 198};
    QCOMPARE(image.pixelColor(pixelAt(fixture, middle)), fixture.theme.tokens().body);
    for (const sim::Vec2 corner : corners) {
        const sim::Vec2 out = corner - middle;
        const double length = sim::length(out);
        QVERIFY(!isPaper(fixture, image, pixelAt(fixture, corner - (2.0 / length) * out)));
        QVERIFY(isPaper(fixture, image, pixelAt(fixture, corner + (2.0 / length) * out)));
    }
}

void SceneShapesTest::aSkinLooksWhereItGoes()
{
    const auto eyes = [](sim::Vec2 velocity) {
        sim::Scene scene = scenes::pointsAt({{200, 200}, {270, 150}, {340, 200}, {270, 250}});
        drawn_scenes::letGlide(scene, velocity);
        View view = withoutGridOrDiscs(scene);
        view.skins.push_back({{0, 1, 2, 3}, 2});
        SceneFixture fixture({drawn_scenes::step("skin", scene, view)});
        const QImage image = fixture.image();
        QPointF sum;
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const sim::Vec2 place = Camera(fixture.view.viewportTransform()).back(QPointF(x, y));
                if (sim::length(place - sim::Vec2{300, 200}) > 30.0 || !isPaper(fixture, image, {x, y}))
                    continue; // bodyInk is white in the light theme, as paper is
                sum += QPointF(place.x, place.y);
                ++count;
            }
        }
        return count > 20 ? sum / count : QPointF();
    };
    const QPointF still = eyes({});
    QVERIFY2(still.x() > 285.0, "the eyes are towards the front");
    QVERIFY(std::abs(still.y() - 200.0) < 1.0);
    QVERIFY(eyes({8.0, 0.0}).x() > still.x() + 0.5);
    QVERIFY(eyes({0.0, 8.0}).y() > still.y() + 0.5);
}

void SceneShapesTest::aTentacleGetsThinner()
{
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {230, 200}, {270, 200}, {310, 200}, {350, 200}});
    View view = withoutGridOrDiscs(scene);
    view.chains.push_back({{0, 1, 2, 3, 4}, 16.0});
    SceneFixture fixture({drawn_scenes::step("chain", scene, view)});
    hideTheGrid(fixture);
    const QImage image = fixture.image();
    const double zoom = fixture.view.zoom() / 100.0;
    int before = static_cast<int>(16.0 * zoom) + 3;
    for (const double x : {192.0, 230.0, 270.0, 310.0, 345.0}) {
        const int here = thickness(fixture, image, pixelAt(fixture, {x, 200}), {0, 1});
        QVERIFY(here > 0 && here < before);
        before = here;
    }
    QVERIFY(thickness(fixture, image, pixelAt(fixture, {192, 200}), {0, 1}) > 14.0 * zoom);
    QVERIFY(before < 5.0 * zoom);
}

void SceneShapesTest::windStandsStillWithTime()
{
    sim::Scene scene = scenes::pointsAt({{100, 100}});
    lessons::Step step = drawn_scenes::step("wind", scene, withoutGridOrDiscs(scene));
    step.overlays = [](const sim::Scene &, const sim::State &, const sim::Values &) {
        return std::vector<lessons::Overlay>{{.shape = lessons::Overlay::Shape::wind, .a = {270, 200}}};
    };
    SceneFixture fixture({step});
    const auto streaks = [&fixture](std::int64_t frame) {
        fixture.goTo(frame);
        return fixture.image();
    };
    const QImage first = streaks(7);
    const QImage later = streaks(8);
    QVERIFY(first != later);
    QVERIFY(streaks(7) == first);
    const QPoint middle = pixelAt(fixture, {270, 200});
    const QColor ring = first.pixelColor(middle + QPoint(26, 0));
    QVERIFY(ring != fixture.theme.tokens().scene);
    QCOMPARE(first.pixelColor(middle + QPoint(20, 0)), fixture.theme.tokens().scene);
}

SUITE(tst_scene_shapes, SceneShapesTest)
#include "tst_scene_shapes.moc"
