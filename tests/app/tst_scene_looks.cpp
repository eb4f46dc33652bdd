// What a look can say, as it is drawn: legs, sticks, skins, tentacles, what is hidden.

#include "app/ui/scene/sticks.h"
#include "lessons/api/view/view.h"
#include "look_scenes.h"
#include "scene_bench.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace app;
using lessons::View;
using Shape = lessons::BodyView::Shape;

namespace {

QPoint onScreen(const SceneBench &bench, sim::Vec2 place)
{
    return bench.view.viewportTransform().map(QPointF(place.x, place.y)).toPoint();
}

bool isPaper(const SceneBench &bench, const QImage &image, QPoint at)
{
    return image.pixelColor(at) == bench.theme.tokens().scene;
}

/// How many px of the column (or, `down`, of the row) through `at` have a colour that is not the paper's.
int thickness(const SceneBench &bench, const QImage &image, QPoint at, QPoint step)
{
    int count = isPaper(bench, image, at) ? 0 : 1;
    for (const int side : {-1, 1}) {
        for (QPoint p = at + side * step; image.rect().contains(p) && !isPaper(bench, image, p);
             p += side * step)
            ++count;
    }
    return count;
}

lessons::View withoutGridOrDiscs(const sim::Scene &scene)
{
    View look = look_scenes::feetOnly(scene);
    for (lessons::BodyView &body : look.bodies)
        body.shape = Shape::none;
    return look;
}

void hideTheGrid(SceneBench &bench)
{
    Extras extras = bench.view.extras();
    extras.grid = false;
    bench.view.setExtras(extras);
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

class SceneLooksTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { useOwnSettings(m_settings); }
    void aLookIsMadeOnce();
    void aLegBendsAsItsControlPointSays_data();
    void aLegBendsAsItsControlPointSays();
    void aGhostsLegBendsToo();
    void aStickHasTheColourOfItsError_data();
    void aStickHasTheColourOfItsError();
    void whatIsPulledLongGetsThinner();
    void aSpringKeepsItsTurnsAndShowsItsStretch();
    void aSpringToAPlaceEndsThere();
    void aGhostsSpringToAPlaceIsDrawn();
    void softMatterIsFilledAndFine();
    void aLegIsThickAtTheBodyAndThinAtTheFoot();
    void aLimbIsAsWideAsItSays();
    void aJointIsAHollowDisc();
    void whatIsHiddenIsNeitherDrawnNorTaken();
    void aSkinGoesThroughItsPoints();
    void aSkinLooksWhereItGoes();
    void aTentacleGetsThinner();
    void windStandsStillWithTime();

private:
    QTemporaryDir m_settings;
};

void SceneLooksTest::aLookIsMadeOnce()
{
    sim::Scene scene = scenes::pointsAt({{200, 200}, {300, 200}});
    look_scenes::letGlide(scene, {1.0, 0.0});
    lessons::Step step = look_scenes::step("once", scene, look_scenes::feetOnly(scene));
    int made = 0;
    step.view = [&made](const sim::Scene &built, const sim::Values &) {
        ++made;
        return look_scenes::feetOnly(built);
    };
    SceneBench bench({step});
    for (int i = 0; i < 20; ++i)
        bench.session.frameForward();
    bench.goTo(3);
    QCOMPARE(made, 1);
    bench.session.setMethod("semi_implicit_euler"); // another run
    bench.goTo(20);
    QVERIFY(bench.session.picture().look != nullptr);
    QVERIFY(made <= 3);
}

void SceneLooksTest::aLegBendsAsItsControlPointSays_data()
{
    QTest::addColumn<double>("curve");
    QTest::newRow("straight") << 0.0;
    QTest::newRow("bent up") << 60.0;
    QTest::newRow("bent far up") << 120.0;
}

void SceneLooksTest::aLegBendsAsItsControlPointSays()
{
    QFETCH(double, curve);
    const sim::Vec2 body{210, 220};
    const sim::Vec2 foot{330, 260};
    const sim::Scene scene = scenes::pointsAt({body, foot});
    View look = withoutGridOrDiscs(scene);
    look.legs.push_back({0, 1, curve});
    SceneBench bench({look_scenes::step("leg", scene, look)});
    hideTheGrid(bench);
    const QImage image = bench.image();
    // B(1/2) = (body + 2 control + foot) / 4
    const sim::Vec2 middle = 0.25 * (body + 2.0 * (foot - sim::Vec2{0, curve}) + foot);
    const sim::Vec2 straight = 0.5 * (body + foot);
    QVERIFY(!isPaper(bench, image, onScreen(bench, curve > 0.0 ? middle : straight)));
    QCOMPARE(isPaper(bench, image, onScreen(bench, straight)), curve > 0.0);
}

void SceneLooksTest::aGhostsLegBendsToo()
{
    sim::Scene scene = scenes::pointsAt({{210, 220}, {330, 260}});
    look_scenes::letGlide(scene, {0.0, 1.0});
    View look = look_scenes::feetOnly(scene);
    look.legs.push_back({0, 1, 80.0});
    SceneBench bench({look_scenes::step("leg", scene, look)});
    hideTheGrid(bench);
    bench.goTo(10);
    bench.goTo(2);
    for (const char *body : {"p0", "p1"}) {
        bench.session.grab(body);
        bench.session.moveHand({270, 330});
        bench.session.letGo();
    }
    bench.goTo(10);
    QVERIFY(bench.session.ghost().has_value());
    const QImage image = bench.image();
    const sim::Vec2 middle{0.25 * (210 + 3 * 330), 10 + 0.25 * (220 + 2 * 180 + 260)};
    const QPoint at = onScreen(bench, middle);
    int inked = 0; // dashes: some of the px near by are, some are not
    for (int x = -6; x <= 6; ++x) {
        for (int y = -6; y <= 6; ++y)
            inked += isPaper(bench, image, at + QPoint(x, y)) ? 0 : 1;
    }
    QVERIFY(inked > 8 && inked < 90);
}

void SceneLooksTest::aStickHasTheColourOfItsError_data()
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

void SceneLooksTest::aStickHasTheColourOfItsError()
{
    QFETCH(double, error);
    QFETCH(QString, expected);
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
    View look = withoutGridOrDiscs(scene);
    look.sticks.push_back({0, 1, 160.0 / (1.0 + error), 6.0});
    SceneBench bench({look_scenes::step("stick", scene, look)});
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        bench.theme.setScheme(scheme);
        const Tokens &t = bench.theme.tokens();
        const QColor color = expected == "stick" ? t.stick : expected == "near" ? t.near : t.past;
        QCOMPARE(bench.image().pixelColor(onScreen(bench, {270, 200})), color);
    }
}

void SceneLooksTest::whatIsPulledLongGetsThinner()
{
    const auto width = [](double error) {
        const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
        View look = withoutGridOrDiscs(scene);
        look.sticks.push_back({0, 1, 160.0 / (1.0 + error), 6.0});
        SceneBench bench({look_scenes::step("stick", scene, look)});
        hideTheGrid(bench);
        return thickness(bench, bench.image(), onScreen(bench, {270, 200}), {0, 1});
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
    View look = withoutGridOrDiscs(scene);
    look.springs.push_back({0, 1, rest});
    SceneBench bench({look_scenes::step("spring", scene, look)});
    hideTheGrid(bench);
    const QImage image = bench.image();
    // Without the straight ends.
    const QPoint from = onScreen(bench, {150 + 0.15 * length, 200});
    const QPoint to = onScreen(bench, {150 + 0.85 * length, 200});
    DrawnSpring drawn;
    bool wasInked = true;
    int top = from.y(), bottom = from.y();
    for (int x = from.x(); x <= to.x(); ++x) {
        const bool isInked = !isPaper(bench, image, {x, from.y()});
        drawn.crossings += isInked && !wasInked ? 1 : 0;
        wasInked = isInked;
        for (int y = from.y() - 40; y <= from.y() + 40; ++y) {
            if (isPaper(bench, image, {x, y}))
                continue;
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    }
    drawn.height = bottom - top;
    return drawn;
}

}

void SceneLooksTest::aSpringKeepsItsTurnsAndShowsItsStretch()
{
    const DrawnSpring pressed = drawnSpring(80.0, 120.0);
    const DrawnSpring asItIs = drawnSpring(120.0, 120.0);
    const DrawnSpring stretched = drawnSpring(240.0, 120.0);
    QVERIFY(asItIs.crossings > 10);
    QVERIFY(std::abs(stretched.crossings - asItIs.crossings) <= 2); // the ends of the count
    QVERIFY(std::abs(pressed.crossings - asItIs.crossings) <= 2);
    QVERIFY(pressed.height > asItIs.height + 1);
    QVERIFY(stretched.height < asItIs.height - 2);
}

void SceneLooksTest::aSpringToAPlaceEndsThere()
{
    sim::Scene scene = scenes::pointsAt({{210, 200}});
    look_scenes::letGlide(scene, {0.0, 4.0});
    View look = withoutGridOrDiscs(scene);
    look.springs.push_back({0, -1, 0.0, {290, 200}});
    SceneBench bench({look_scenes::step("spring", scene, look)});
    hideTheGrid(bench);
    const auto isSpring = [&](sim::Vec2 place) {
        const QImage image = bench.image();
        const QPoint at = onScreen(bench, place);
        for (int x = -2; x <= 2; ++x) {
            for (int y = -2; y <= 2; ++y) {
                if (isInk(image.pixelColor(at + QPoint(x, y)), bench.theme.tokens().spring))
                    return true;
            }
        }
        return false;
    };
    for (const int frame : {0, 10}) {
        bench.goTo(frame);
        const sim::Vec2 from = bench.place("p0"), way = sim::Vec2{290, 200} - from;
        QVERIFY(isSpring(from + 0.05 * way) && isSpring(from + 0.95 * way));
        const double beyond = 10.0 / (bench.view.transform().m11() * sim::length(way)); // 10 px of the screen
        QVERIFY(!isSpring(from - beyond * way) && !isSpring(from + (1.0 + beyond) * way));
    }
}

void SceneLooksTest::aGhostsSpringToAPlaceIsDrawn()
{
    sim::Scene scene = scenes::pointsAt({{210, 200}});
    look_scenes::letGlide(scene, {0.0, 4.0});
    View look = withoutGridOrDiscs(scene);
    look.bodies[0].shape = Shape::foot;
    look.springs.push_back({0, -1, 0.0, {290, 200}});
    SceneBench bench({look_scenes::step("spring", scene, look)});
    hideTheGrid(bench);
    bench.goTo(10);
    bench.goTo(2);
    bench.session.grab("p0");
    bench.session.moveHand({210, 250});
    bench.session.letGo();
    bench.goTo(10);
    QVERIFY(bench.session.ghost().has_value());
    const QImage image = bench.image();
    int inked = 0; // along the way from where it was to the place
    for (int i = 20; i <= 80; ++i) {
        const double t = i / 100.0;
        inked += isPaper(bench, image, onScreen(bench, {210 + 80 * t, 240 - 40 * t})) ? 0 : 1;
    }
    QVERIFY(inked > 15 && inked < 60); // dashes
}

void SceneLooksTest::softMatterIsFilledAndFine()
{
    const sim::Scene scene = scenes::pointsAt({{200, 150}, {340, 150}, {340, 250}, {200, 250}});
    View look = withoutGridOrDiscs(scene);
    look.sheets.push_back({{0, 1, 2, 3}});
    using Part = lessons::SpringView::Part;
    look.springs.push_back({0, 1, 140.0, {}, Part::edge});
    SceneBench bench({look_scenes::step("sheet", scene, look)});
    hideTheGrid(bench);
    QImage image = bench.image();
    QVERIFY(!isPaper(bench, image, onScreen(bench, {270, 200})));
    QVERIFY(isPaper(bench, image, onScreen(bench, {190, 200})));
    QVERIFY(isInk(image.pixelColor(onScreen(bench, {270, 150})), bench.theme.tokens().spring));
    QVERIFY(isPaper(bench, image, onScreen(bench, {270, 150}) - QPoint(0, 4))); // a line, no zigzag
    bench.theme.setScheme(Scheme::highContrast);
    QVERIFY(isPaper(bench, bench.image(), onScreen(bench, {270, 200}))); // nothing but black, white and kinds
}

void SceneLooksTest::aLegIsThickAtTheBodyAndThinAtTheFoot()
{
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
    for (const double curve : {0.0, 1.0}) {
        View look = withoutGridOrDiscs(scene);
        look.legs.push_back({0, 1, curve});
        SceneBench bench({look_scenes::step("leg", scene, look)});
        hideTheGrid(bench);
        const QImage image = bench.image();
        const int atBody = thickness(bench, image, onScreen(bench, {200, 200}), {0, 1});
        const int atFoot = thickness(bench, image, onScreen(bench, {340, 200}), {0, 1});
        QVERIFY(atFoot >= 1 && atBody > atFoot);
    }
}

void SceneLooksTest::aLimbIsAsWideAsItSays()
{
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {350, 200}});
    View look = withoutGridOrDiscs(scene);
    look.limbs.push_back({0, 1, 20.0});
    SceneBench bench({look_scenes::step("limb", scene, look)});
    hideTheGrid(bench);
    const QImage image = bench.image();
    const double zoom = bench.view.zoom() / 100.0;
    QVERIFY(std::abs(thickness(bench, image, onScreen(bench, {270, 200}), {0, 1}) - 20.0 * zoom) < 3.0);
    QCOMPARE(image.pixelColor(onScreen(bench, {270, 200})), bench.theme.tokens().body);
    // Round ends: it goes on for nearly half its width.
    QVERIFY(!isPaper(bench, image, onScreen(bench, {350 + 9, 200})));
    QVERIFY(isPaper(bench, image, onScreen(bench, {350 + 11.5, 200})));
    QVERIFY(isPaper(bench, image, onScreen(bench, {350 + 9, 200 + 9})));
}

void SceneLooksTest::aJointIsAHollowDisc()
{
    const sim::Scene scene = scenes::pointsAt({{270, 200}, {320, 240}});
    View look = withoutGridOrDiscs(scene);
    look.bodies[0] = {Shape::joint, 6.0};
    SceneBench bench({look_scenes::step("joint", scene, look)});
    hideTheGrid(bench);
    bench.session.select("p1");
    const QImage image = bench.image();
    QVERIFY(isPaper(bench, image, onScreen(bench, {270, 200})));
    QCOMPARE(image.pixelColor(onScreen(bench, {275.2, 200})), bench.theme.tokens().stick);
    bench.press(onScreen(bench, {270, 200}));
    QCOMPARE(bench.session.selected(), "p0");
}

void SceneLooksTest::whatIsHiddenIsNeitherDrawnNorTaken()
{
    const sim::Scene scene = scenes::pointsAt({{270, 200}, {320, 240}});
    View look = withoutGridOrDiscs(scene);
    look.bodies[1].shape = Shape::foot;
    SceneBench bench({look_scenes::step("hidden", scene, look)});
    hideTheGrid(bench);
    const QPoint hidden = onScreen(bench, {270, 200});
    QCOMPARE(bench.session.selected(), "p0"); // no ring, no name
    QVERIFY(bench.pixels(bench.theme.tokens().ink) == 0);
    QVERIFY(isPaper(bench, bench.image(), hidden));
    bench.move(hidden, Qt::NoButton);
    QCOMPARE(bench.view.viewport()->cursor().shape(), Qt::ArrowCursor);
    bench.press(hidden);
    bench.move(hidden + QPoint(30, 0));
    QVERIFY(!bench.session.isHolding());
    bench.release(hidden + QPoint(30, 0));
    // Where both are out of the picture, only the one that shows has a sign at the edge.
    while (bench.view.zoom() < 1500.0)
        bench.wheel({20, 450}, {0, 120});
    QVERIFY(!bench.view.viewport()->rect().contains(onScreen(bench, {270, 200})));
    QVERIFY(!bench.view.viewport()->rect().contains(onScreen(bench, {320, 240})));
    Overlay overlay(bench.view.shown(), bench.view.beside(), bench.theme);
    const auto markers = overlay.markers(Camera(bench.view.viewportTransform()), QRectF(0, 0, 600, 470));
    QCOMPARE(markers.size(), 1U);
    QCOMPARE(markers[0].bodies, 1);
    QCOMPARE(markers[0].point, 1);
}

void SceneLooksTest::aSkinGoesThroughItsPoints()
{
    const std::vector<sim::Vec2> corners{{210, 200}, {250, 150}, {320, 170}, {340, 220}, {280, 250}};
    const sim::Scene scene = scenes::pointsAt(corners);
    View look = withoutGridOrDiscs(scene);
    look.skins.push_back({{0, 1, 2, 3, 4}, -1});
    SceneBench bench({look_scenes::step("skin", scene, look)});
    hideTheGrid(bench);
    const QImage image = bench.image();
    const sim::Vec2 middle{280, 198};
    QCOMPARE(image.pixelColor(onScreen(bench, middle)), bench.theme.tokens().body);
    for (const sim::Vec2 corner : corners) {
        const sim::Vec2 out = corner - middle;
        const double length = sim::length(out);
        QVERIFY(!isPaper(bench, image, onScreen(bench, corner - (2.0 / length) * out)));
        QVERIFY(isPaper(bench, image, onScreen(bench, corner + (2.0 / length) * out)));
    }
}

void SceneLooksTest::aSkinLooksWhereItGoes()
{
    const auto eyes = [](sim::Vec2 velocity) {
        sim::Scene scene = scenes::pointsAt({{200, 200}, {270, 150}, {340, 200}, {270, 250}});
        look_scenes::letGlide(scene, velocity);
        View look = withoutGridOrDiscs(scene);
        look.skins.push_back({{0, 1, 2, 3}, 2});
        SceneBench bench({look_scenes::step("skin", scene, look)});
        const QImage image = bench.image();
        QPointF sum;
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const sim::Vec2 place = Camera(bench.view.viewportTransform()).back(QPointF(x, y));
                if (sim::length(place - sim::Vec2{300, 200}) > 30.0 || !isPaper(bench, image, {x, y}))
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

void SceneLooksTest::aTentacleGetsThinner()
{
    const sim::Scene scene = scenes::pointsAt({{190, 200}, {230, 200}, {270, 200}, {310, 200}, {350, 200}});
    View look = withoutGridOrDiscs(scene);
    look.chains.push_back({{0, 1, 2, 3, 4}, 16.0});
    SceneBench bench({look_scenes::step("chain", scene, look)});
    hideTheGrid(bench);
    const QImage image = bench.image();
    const double zoom = bench.view.zoom() / 100.0;
    int before = static_cast<int>(16.0 * zoom) + 3;
    for (const double x : {192.0, 230.0, 270.0, 310.0, 345.0}) {
        const int here = thickness(bench, image, onScreen(bench, {x, 200}), {0, 1});
        QVERIFY(here > 0 && here < before);
        before = here;
    }
    QVERIFY(thickness(bench, image, onScreen(bench, {192, 200}), {0, 1}) > 14.0 * zoom);
    QVERIFY(before < 5.0 * zoom);
}

void SceneLooksTest::windStandsStillWithTime()
{
    sim::Scene scene = scenes::pointsAt({{100, 100}});
    lessons::Step step = look_scenes::step("wind", scene, withoutGridOrDiscs(scene));
    step.overlays = [](const sim::Scene &, const sim::State &, const sim::Values &) {
        return std::vector<lessons::Overlay>{{.shape = lessons::Overlay::Shape::wind, .a = {270, 200}}};
    };
    SceneBench bench({step});
    const auto streaks = [&bench](std::int64_t frame) {
        bench.goTo(frame);
        return bench.image();
    };
    const QImage first = streaks(7);
    const QImage later = streaks(8);
    QVERIFY(first != later);
    QVERIFY(streaks(7) == first);
    const QPoint middle = onScreen(bench, {270, 200});
    const QColor ring = first.pixelColor(middle + QPoint(26, 0));
    QVERIFY(ring != bench.theme.tokens().scene);
    QCOMPARE(first.pixelColor(middle + QPoint(20, 0)), bench.theme.tokens().scene);
}

QTEST_MAIN(SceneLooksTest)
#include "tst_scene_looks.moc"
