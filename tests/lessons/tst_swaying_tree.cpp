#include "lessons/api/view/view.h"
#include "sim/base/direction.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "tests/lessons/support/printed_tree.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace support;
using Stage = PrintedTree::Stage;

Q_DECLARE_METATYPE(PrintedTree::Stage)

/// The steps of the tutorial's tree. The step `real_sway`, which is not published, is in tst_real_sway.
class SwayingTree : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("swaying_tree"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    static void addWindSteps()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"wind", "rest", "distance", "thickness", "turbulence"})
            QTest::newRow(id) << QString::fromUtf8(id);
    }

    sim::Script pressed(const char *id, sim::Vec2 at, const Changes &changes = {}, double h = 1.0) const
    {
        sim::Script script = scriptOf(step(id), "published", h, changes);
        script.input = {{1, sim::Pointer{at, true}}};
        return script;
    }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("swaying_tree")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesPrintedCode_data();
    void matchesPrintedCode();
    void correctedBranchesPointAtThePointerAfterOneFrame();
    void aimingFromTheEndIsUnstableNearThePointer();
    void correctedWindBlowsAwayFromThePointer();
    void bendTurnsTheShortWay_data();
    void bendTurnsTheShortWay();
    void pointerOnABranchEndIsHandled_data();
    void pointerOnABranchEndIsHandled();
    void correctedWindNeverOvershoots();
    void smallerStepsConverge_data();
    void smallerStepsConverge();
    void heldBranchKeepsItsAngleAndMovesItsChildren_data();
    void heldBranchKeepsItsAngleAndMovesItsChildren();
    void windIsDrawnWhileTheButtonIsDown();
    void theLargestBendIsTheShortWay();
    void bendBeforeTheTreeChangedDoesNotCount();
};

void SwayingTree::matchesPrintedCode_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<Stage>("stage");
    QTest::addColumn<int>("seed");
    const std::pair<const char *, Stage> all[] = {{"trunk", Stage::still},
                                                  {"branches", Stage::still},
                                                  {"randomness", Stage::still},
                                                  {"towards_pointer", Stage::towardsPointer},
                                                  {"wind", Stage::wind},
                                                  {"rest", Stage::rest},
                                                  {"distance", Stage::distance},
                                                  {"thickness", Stage::thickness},
                                                  {"turbulence", Stage::turbulence}};
    for (const auto &[id, stage] : all) {
        for (int seed = 0; seed < 12; ++seed)
            QTest::addRow("%s, random numbers %d", id, seed) << QString::fromUtf8(id) << stage << seed;
    }
}

void SwayingTree::matchesPrintedCode()
{
    QFETCH(QString, id);
    QFETCH(Stage, stage);
    QFETCH(int, seed);
    std::mt19937 engine(static_cast<unsigned>(100 * seed + int(stage)));
    const auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    PrintedTree::Numbers numbers;
    if (id == u"trunk")
        numbers.minScale = 1e9; // only a trunk
    if (seed > 0 && id != u"trunk")
        numbers = {real(0, 180), real(0, 40), real(0.4, 0.8), real(0.15, 0.5), real(40, 160),
                   real(2, 20),  real(1, 10), real(0, 60),    unsigned(seed)};
    if (id == u"branches")
        numbers.jitter = 0.0;
    const sim::Values defaults = step(qPrintable(id)).defaultValues();
    sim::Script script = scriptOf(step(qPrintable(id)));
    script.values.seed = numbers.seed;
    const std::pair<const char *, double> values[] = {
        {"formula", 1.0},         {"spread", numbers.spread},         {"jitter", numbers.jitter},
        {"slope", numbers.slope}, {"min_scale", numbers.minScale},    {"base_length", numbers.baseLength},
        {"ease", numbers.ease},   {"turbulence", numbers.turbulence}, {"wind", numbers.wind}};
    for (const auto &[name, value] : values) {
        if (defaults.has(name))
            script.values.set(name, value);
    }
    PrintedTree printed(stage, numbers);
    std::vector<std::pair<bool, double>> gusts(120);
    std::vector<std::tuple<double, double, bool>> mice(120);
    for (int frame = 1; frame < 120; ++frame) {
        const auto index = static_cast<std::size_t>(frame);
        mice[index] = {real(-50, 600), real(-50, 450), real(0, 1) < 0.7};
        gusts[index] = {stage == Stage::turbulence && real(0, 1) < 0.5, real(-30, 30)};
        const auto &[x, y, down] = mice[index];
        script.input.push_back({frame, sim::Pointer{{x, y}, down}});
        if (gusts[index].first)
            script.input.push_back({frame, sim::Gust{gusts[index].second}});
    }
    sim::Timeline run(script);
    for (int frame = 0; frame < 120; ++frame) {
        run.seek({frame, 0});
        if (frame > 0) {
            const auto index = static_cast<std::size_t>(frame);
            const auto &[x, y, down] = mice[index];
            printed.mouse(x, y, down);
            printed.enterFrame(gusts[index].first ? &gusts[index].second : nullptr);
        }
        const std::vector<PrintedTree::BranchPose> poses = printed.branchPoses();
        QCOMPARE(run.state().pointCount(), static_cast<int>(poses.size()));
        for (int i = 0; i < run.state().pointCount(); ++i) {
            const PrintedTree::BranchPose &pose = poses[static_cast<std::size_t>(i)];
            QVERIFY(std::abs(run.state().angle[i] - pose.angle) <= 1e-6);
            QVERIFY(sim::length(run.state().positionOf(i) - sim::Vec2{pose.x, pose.y}) <= 1e-6);
        }
    }
}

void SwayingTree::correctedBranchesPointAtThePointerAfterOneFrame()
{
    for (const sim::Vec2 pointer : {sim::Vec2{20, 30}, {500, 390}, {290, 330}, {275, 250}}) {
        const sim::State after = stateAfter(pressed("towards_pointer", pointer), 1);
        for (int i = 0; i < after.pointCount(); ++i) {
            const sim::Vec2 toPointer = pointer - after.positionOf(i);
            const double angle = std::atan2(toPointer.y, toPointer.x) * 180.0 / std::numbers::pi;
            QVERIFY(sim::length(toPointer) < 1e-9 ||
                    std::abs(std::remainder(after.angle[i] - angle, 360.0)) < 1e-9);
        }
    }
}

/// Shows why the corrected formula aims from the origin. Take a pointer at distance D and a branch of length
/// L. Aiming from the end multiplies a small angle error by -L / (D - L) per frame. Adding the end gives L /
/// (D + L).
void SwayingTree::aimingFromTheEndIsUnstableNearThePointer()
{
    const auto errorAfter = [](double sign, double D) {
        double angle = 0.02; // rad; the pointer is along 0
        for (int frame = 0; frame < 30; ++frame)
            angle = std::atan2(sign * 100.0 * std::sin(angle), D + sign * 100.0 * std::cos(angle));
        return std::abs(angle);
    };
    QVERIFY(errorAfter(1.0, 150.0) < 1e-9);
    QVERIFY(errorAfter(-1.0, 250.0) < 1e-3);
    QVERIFY(errorAfter(-1.0, 150.0) > 0.5);
}

void SwayingTree::correctedWindBlowsAwayFromThePointer()
{
    for (const sim::Vec2 pointer : {sim::Vec2{60, 200}, {500, 100}, {275, 380}}) {
        const sim::Script script = pressed("wind", pointer);
        const sim::State after = stateAfter(script, 400);
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const lessons::View view = step("wind").view(scene, script.values);
        for (int i = 0; i < after.pointCount(); ++i) {
            const double rad = after.angle[i] * std::numbers::pi / 180.0;
            const double length = view.tree->length[static_cast<std::size_t>(i)];
            const sim::Vec2 end = after.positionOf(i) + length * sim::Vec2{std::cos(rad), std::sin(rad)};
            const sim::Vec2 away = end - pointer;
            const double wind = std::atan2(away.y, away.x) * 180.0 / std::numbers::pi;
            QVERIFY(std::abs(std::remainder(after.angle[i] - wind, 360.0)) <= 1.0);
        }
    }
}

void SwayingTree::bendTurnsTheShortWay_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("wind");
    QTest::addColumn<double>("corrected"); // half of the difference is added
    QTest::addColumn<double>("published");
    QTest::newRow("20 degrees") << -10.0 << 10.0 << 0.0 << 0.0;
    QTest::newRow("190 down is 170 up, in both formulas") << 0.0 << -190.0 << 85.0 << 85.0;
    QTest::newRow("190 up is 170 down, published turns the long way") << 0.0 << 190.0 << -85.0 << 95.0;
    QTest::newRow("340 up is 20 down, published turns the long way") << -170.0 << 170.0 << -180.0 << 0.0;
    QTest::newRow("370 up is 10 up, in both formulas") << 0.0 << 370.0 << 5.0 << 5.0;
    QTest::newRow("two turns away") << -700.0 << 10.0 << -705.0 << -525.0;
    QTest::newRow("within a degree") << 5.0 << 5.9 << 5.0 << 5.0;
}

void SwayingTree::bendTurnsTheShortWay()
{
    QFETCH(double, angle);
    QFETCH(double, wind);
    QTEST(sim::bend(angle, wind, 2.0, 1.0), "corrected");
    QTEST(sim::bendPublished(angle, wind, 2.0, 1.0), "published");
}

void SwayingTree::pointerOnABranchEndIsHandled_data()
{
    addWindSteps();
    QTest::newRow("towards_pointer") << "towards_pointer";
}

void SwayingTree::pointerOnABranchEndIsHandled()
{
    QFETCH(QString, id);
    const Changes plain = {{"jitter", 0.0}};
    const sim::State start = stateAfter(scriptOf(step(qPrintable(id)), "published", 1.0, plain), 0);
    for (const int branch : {1, 2, 3, 6, 7, 200}) { // the origin of a branch is the end of its parent
        sim::Script script = pressed(qPrintable(id), start.positionOf(branch), plain);
        sim::Timeline run(script);
        run.seek({200, 0});
        QVERIFY(!run.stop());
        QVERIFY(run.state().angle.isFinite().all() && run.state().position.isFinite().all());
    }
}

void SwayingTree::correctedWindNeverOvershoots()
{
    for (const double strength : {0.0, 1e-9, 0.3, 0.9, 1.0, 7.0, 1e300}) {
        for (const double h : {0.125, 1.0, 10.0}) {
            const double share = std::min(1.0, h / strength); // of the 50 degrees to the wind
            QVERIFY(std::abs(sim::bend(-90.0, -40.0, strength, h) - (-90.0 + 50.0 * share)) < 1e-12);
        }
    }
}

void SwayingTree::smallerStepsConverge_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("x");
    QTest::newRow("wind") << "wind" << 40.0;
    QTest::newRow("rest") << "rest" << 40.0;
    QTest::newRow("distance, so weak that no branch returns") << "distance" << -700.0;
    QTest::newRow("thickness") << "thickness" << 40.0;
}

/// A step is one of explicit Euler, of order 1. No branch comes within the 1 degree in which branches stop
/// turning.
void SwayingTree::smallerStepsConverge()
{
    QFETCH(QString, id);
    QFETCH(double, x);
    const auto after = [&](double h) {
        const Changes small = {{"min_scale", 0.5}, {"jitter", 0.0}, {"ease", 20.0}};
        return stateAfter(pressed(qPrintable(id), {x, 120}, small, h), 4);
    };
    const auto error = [&](double h) { return (after(h).angle - after(0.5 * h).angle).abs().maxCoeff(); };
    const OrderRange order = observedOrders(error, 4, 9);
    QVERIFY2(order.min > 0.9 && order.max < 1.1,
             qPrintable(QString::number(order.min) + u' ' + QString::number(order.max)));
}

void SwayingTree::heldBranchKeepsItsAngleAndMovesItsChildren_data()
{
    QTest::addColumn<QString>("id");
    for (const lessons::Step &each : m_lesson.steps)
        QTest::addRow("%s", qPrintable(each.id)) << each.id;
}

void SwayingTree::heldBranchKeepsItsAngleAndMovesItsChildren()
{
    QFETCH(QString, id);
    const lessons::Step &lessonStep = step(qPrintable(id));
    const int held = id == u"trunk" ? 0 : 1;
    sim::Script script = lessonStep.script();
    script.input = {{1, sim::Pointer{{60, 200}, true}},
                    {20, sim::Grab{"branch" + std::to_string(held)}},
                    {20, sim::Move{{200, 150}}},
                    {40, sim::Release{}}};
    sim::Timeline run(script);
    run.seek({19, 0});
    const double angle = run.state().angle[held];
    run.seek({39, 0});
    QCOMPARE(run.state().positionOf(held), (sim::Vec2{200, 150}));
    QCOMPARE(run.state().angle[held], angle);
    const lessons::View view = lessonStep.view(run.track().interval().scene, run.values());
    const double rad = angle * std::numbers::pi / 180.0;
    const double length = view.tree->length[static_cast<std::size_t>(held)];
    const sim::Vec2 end = sim::Vec2{200, 150} + length * sim::Vec2{std::cos(rad), std::sin(rad)};
    int children = 0;
    for (int child = 0; child < run.state().pointCount(); ++child) {
        if (view.tree->parent[static_cast<std::size_t>(child)] != held)
            continue;
        ++children;
        QVERIFY(sim::length(run.state().positionOf(child) - end) < 1e-9);
    }
    QCOMPARE(children, id == u"trunk" ? 0 : 2);
    if (held == 0)
        return;
    run.seek({41, 0});
    // The released branch is back at the end of the trunk.
    QVERIFY(sim::length(run.state().positionOf(held) - sim::Vec2{200, 150}) > 10.0);
}

void SwayingTree::theLargestBendIsTheShortWay()
{
    const lessons::Step &pointer = step("towards_pointer");
    sim::Script script = scriptOf(pointer);
    script.input = {{0, sim::Pointer{{450, 250}, true}}};
    const sim::State state = stateAfter(script, 10);
    const sim::Scene scene = pointer.scene(script.values);
    QVERIFY((state.angle - scene.start.angle).abs().maxCoeff() > 180.0); // full turns are counted there
    const double bend = pointer.measures.front().of(scene, state, nullptr, script.values);
    QVERIFY2(bend > 1.0 && bend <= 180.0, qPrintable(QString::number(bend)));
}

void SwayingTree::bendBeforeTheTreeChangedDoesNotCount()
{
    const lessons::Step &rest = step("rest");
    sim::Script script = pressed("rest", {275, 390});
    script.input.push_back({60, sim::Pointer{{275, 390}, false}});
    sim::Timeline same(script);
    same.seek({300, 0});
    QVERIFY(rest.tries[0].isDone(same)); // bent, let go, and back
    script.input.push_back({200, sim::Set{"min_scale", 0.15}});
    sim::Timeline grown(script);
    grown.seek({300, 0});
    QVERIFY(grown.state().pointCount() > same.state().pointCount());
    QVERIFY(!rest.tries[0].isDone(grown));
}

void SwayingTree::windIsDrawnWhileTheButtonIsDown()
{
    int drawn = 0;
    for (const lessons::Step &each : m_lesson.steps) {
        if (!each.overlays || each.id == u"trunk")
            continue;
        ++drawn;
        const sim::Values values = each.defaultValues();
        const sim::Scene scene = each.scene(values);
        sim::State state = scene.start;
        state.input.pointer = {{60, 200}};
        QVERIFY(each.overlays(scene, state, values).empty());
        state.input.pointerDown = true;
        const std::vector<lessons::Overlay> overlays = each.overlays(scene, state, values);
        QVERIFY(!overlays.empty());
        QCOMPARE(overlays.front().a, (sim::Vec2{60, 200}));
        const bool isWind = overlays.front().shape == lessons::Overlay::Shape::wind;
        QCOMPARE(isWind, each.id != u"towards_pointer");
    }
    QVERIFY(drawn >= 5);
}

SUITE(tst_swaying_tree, SwayingTree)
#include "tst_swaying_tree.moc"
