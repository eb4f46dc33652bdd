#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/support.h"

#include "tests/bench/scenes/crowd.h"

#include "sim/base/error.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/room_limits.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drags/split_damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"
#include "sim/scene/islands.h"
#include "sim/scenes/sticks.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

namespace {

using std::make_shared;

/// Returns `each` islands of four kinds, stored kind by kind:
/// - pairs of different masses on body springs, one of them listed twice, with damping along and across the
///   pair;
/// - bodies with two legs that pull back, one foot numbered below its body and one above;
/// - three points that push each other;
/// - single points on springs to a fixed position, the first of which is held.
sim::Scene mixedIslands(int each)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(9 * each);
    support::scatter(scene.start, 5, 300.0);
    scene.groups = {{"first", {0, 4 * each}}, {"second", {4 * each, 5 * each}}};
    std::vector<sim::Link> links;
    std::vector<sim::Leg> legs;
    std::vector<int> feet;
    for (int i = 0; i < each; ++i) {
        links.push_back({i, each + i});
        links.push_back({each + i, i});
        links.push_back({i, each + i}); // listed twice
        scene.start.inverseMass[i] = 1.0 / (1.0 + i % 3);
        const int body = 3 * each + i;
        legs.push_back({2 * each + i, body, 0.3, 0});
        legs.push_back({4 * each + i, body, 2.0, 0});
        feet.push_back(2 * each + i);
        const std::vector<int> three = {5 * each + i, 6 * each + i, 7 * each + i};
        scene.effects.push_back(make_shared<sim::Push>(three, 0.2, 80.0, sim::Reaction::equal));
        scene.effects.push_back(make_shared<sim::SplitDamping>(i, each + i, 0.9, 0.7));
        scene.effects.push_back(make_shared<sim::PointSpring>(8 * each + i, sim::Vec2{250.0, 90.0}, 0.05));
    }
    scene.start.inverseMass[8 * each] = 0.0;
    const sim::LegRule rule{0.1, 50.0, 50.0, sim::Aim::below, sim::Reaction::equal};
    scene.effects.insert(scene.effects.end(),
                         {make_shared<sim::BodySpring>(links, 0.2), make_shared<sim::LegSpring>(legs, rule),
                          make_shared<sim::Gravity>(0.5),
                          make_shared<sim::Damping>(0.9, sim::PointRange{3, 6 * each}),
                          make_shared<sim::Ground>(feet, sim::GroundPlane{320.0, 0.2, sim::Traction::full})});
    return scene;
}

/// Returns single points in a room with friction.
sim::Scene loosePoints(int points)
{
    sim::Scene scene = scenes::pointsAt(std::vector<sim::Vec2>(static_cast<std::size_t>(points)));
    support::scatter(scene.start, 8, 400.0);
    const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(points, 5.0);
    scene.effects = {make_shared<sim::Gravity>(0.5), make_shared<sim::Damping>(0.98),
                     make_shared<sim::RoomLimits>(sim::Room{200.0, 350.0, 300.0, 0.0}, half, 0.4)};
    return scene;
}

/// Returns triangles of sticks. The points are stored triangle by triangle, the sticks side by side.
sim::Scene triangles(int count)
{
    scenes::StickFigure all{.gravity = 0.5, .damp = 0.98, .passes = 4};
    all.places.resize(static_cast<std::size_t>(3 * count));
    for (int side = 0; side < 3; ++side) {
        for (int i = count - 1; i >= 0; --i)
            all.sticks.push_back({3 * i + (side + 1) % 3, 3 * i + side, 40.0 + side, 0.3});
    }
    sim::Scene scene = scenes::fallingSticks(all);
    support::scatter(scene.start, 6, 300.0);
    return scene;
}

/// Returns mixedIslands() with the leg springs first.
sim::Scene mixedIslandsLegsFirst(int each)
{
    sim::Scene scene = mixedIslands(each);
    std::stable_partition(scene.effects.begin(), scene.effects.end(), [](const sim::EffectPtr &effect) {
        return dynamic_cast<const sim::LegSpring *>(effect.get()) != nullptr;
    });
    return scene;
}

sim::Scene sceneByName(const QString &name)
{
    if (name == u"legs first")
        return mixedIslandsLegsFirst(12);
    if (name == u"a crowd")
        return bench::crowd::inTheRoom(40);
    return name == u"many kinds" ? mixedIslands(12) : loosePoints(90);
}

sim::Pipeline inBlocks(const sim::Scene &scene, const std::string &method, sim::BlockSize size)
{
    sim::Pipeline pipeline = sim::compose(scene, *sim::findMethod(method), sim::StepSize::ofLength(0.5));
    pipeline.blocks = sim::cacheBlocksOf(scene, pipeline.phases, size);
    return pipeline;
}

}

/// A step in cache blocks gives the same bits as a step phase by phase.
class TestCacheBlocks : public QObject
{
    Q_OBJECT

    static constexpr auto methods = {"published", "semi_implicit_euler", "explicit_euler", "position_verlet",
                                     "velocity_verlet"};

    static void addBlockMethodRows()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : methods)
            QTest::newRow(method) << QString(method);
    }

    static void addRows()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("points"); // per block
        for (const QString scene : {"a crowd", "many kinds", "legs first", "loose points"}) {
            for (const char *method : methods) {
                for (const int points : {1, 20, 64})
                    QTest::addRow("%s by %s, %d points per block", qPrintable(scene), method, points)
                        << scene << QString(method) << points;
            }
        }
    }

private slots:
    void blocksGiveTheSameBitsWithAnyNumberOfThreads_data() { addRows(); }
    void blocksGiveTheSameBitsWithAnyNumberOfThreads()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        QFETCH(int, points);
        const sim::Scene chosen = sceneByName(scene);
        const sim::Pipeline pipeline = inBlocks(chosen, method.toStdString(), {points, 1});
        QVERIFY(pipeline.blocks.size() >= 2);
        sim::State plain = chosen.start;
        sim::findMethod(method.toStdString())->prepareState(plain);
        std::vector<sim::State> states(3, plain);
        std::vector<sim::ThreadPool> pools = {sim::ThreadPool(1), sim::ThreadPool(2), sim::ThreadPool(3)};
        for (plain.frame = 1; plain.frame <= 200; ++plain.frame) {
            for (const sim::Phase &phase : pipeline.phases)
                phase.run(plain);
            for (std::size_t i = 0; i < states.size(); ++i) {
                states[i].frame = plain.frame;
                sim::runStep(pipeline, states[i], pools[i]);
            }
        }
        for (sim::State &state : states) {
            state.frame = plain.frame;
            const std::string difference = support::difference(state, plain);
            QVERIFY2(difference.empty(), difference.c_str());
        }
    }

    void blocksContainEachPointOnce_data() { addRows(); }
    void blocksContainEachPointOnce()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        QFETCH(int, points);
        const sim::Scene chosen = sceneByName(scene);
        const sim::Pipeline pipeline = inBlocks(chosen, method.toStdString(), {points, 1});
        std::vector<int> blockOf(static_cast<std::size_t>(chosen.start.pointCount()), -1);
        for (std::size_t block = 0; block < pipeline.blocks.size(); ++block) {
            int end = -1;
            for (const sim::PointRange &range : pipeline.blocks[block].ranges) {
                QVERIFY(range.first > end); // neighbours are in one range
                end = range.end();
                for (int i = range.first; i < range.end(); ++i) {
                    int &owner = blockOf[static_cast<std::size_t>(i)];
                    QCOMPARE(owner, -1);
                    owner = static_cast<int>(block);
                }
            }
        }
        QVERIFY(std::find(blockOf.begin(), blockOf.end(), -1) == blockOf.end());
        for (const auto &island : sim::islandsOf(chosen)) { // no island is split
            const int block = blockOf[static_cast<std::size_t>(island.front().first)];
            for (const sim::PointRange &range : island) {
                for (int i = range.first; i < range.end(); ++i)
                    QCOMPARE(blockOf[static_cast<std::size_t>(i)], block);
            }
        }
    }

    void noBlocksWhereTheyAreImpossibleOrDoNotPay()
    {
        const auto count = [](const sim::Scene &scene, const char *method, sim::BlockSize size) {
            return inBlocks(scene, method, size).blocks.size();
        };
        const sim::Scene crowd = bench::crowd::inTheRoom(40);
        QVERIFY(count(crowd, "semi_implicit_euler", {60, 1}) > 1);
        QCOMPARE(count(crowd, "rk4", {60, 1}), std::size_t{0}); // its stages need all points at once
        QCOMPARE(count(crowd, "semi_implicit_euler", {240, 1}),
                 std::size_t{0}); // all points fit into one block
        QVERIFY(count(crowd, "semi_implicit_euler", {60, 10}) > 1);
        QCOMPARE(count(crowd, "semi_implicit_euler", {60, 11}),
                 std::size_t{0}); // the longest range has 10 points
        sim::Scene walking = crowd;
        walking.start.gait.setZero(1);
        walking.start.gaitSpeed.setZero(1);
        walking.effects.push_back(make_shared<sim::GaitClock>());
        QCOMPARE(count(walking, "semi_implicit_euler", {60, 1}), std::size_t{0});
        // Each block would have to go through the whole list of sticks.
        QCOMPARE(count(triangles(30), "semi_implicit_euler", {30, 1}), std::size_t{0});
    }

    void sticksCanBeEnforcedIslandByIsland_data() { addBlockMethodRows(); }
    void sticksCanBeEnforcedIslandByIsland()
    {
        QFETCH(QString, method);
        const sim::Scene scene = triangles(30);
        sim::Pipeline pipeline = inBlocks(scene, method.toStdString(), {30, 1});
        for (int triangle = 29; triangle >= 0; --triangle) { // in any order
            const std::vector<sim::PointRange> ranges = {{3 * triangle, 3}};
            pipeline.blocks.push_back({ranges, {}});
            for (const sim::StepKernel &stepKernel : pipeline.kernels)
                pipeline.blocks.back().work.push_back(stepKernel.kernel.prepareFor(ranges));
        }
        sim::State plain = scene.start;
        sim::findMethod(method.toStdString())->prepareState(plain);
        sim::State state = plain;
        for (int frame = 0; frame < 200; ++frame) {
            for (const sim::Phase &phase : pipeline.phases)
                phase.run(plain);
            sim::runStep(pipeline, state);
        }
        QVERIFY(sim::sameBits(state, plain));
    }

    void trackRunsInBlocksAndStopsAtAnyPhase_data() { addBlockMethodRows(); }
    void trackRunsInBlocksAndStopsAtAnyPhase()
    {
        QFETCH(QString, method);
        const sim::Scene crowd = bench::crowd::inTheRoom(3000);
        const sim::Script script = support::script(crowd, method.toStdString(), 0.5);
        sim::Track track(script, 0);
        QVERIFY(track.interval().pipeline.blocks.size() > 1);
        const sim::State plain = support::plainRun(crowd, method.toStdString(), 0.5, 6);
        track.seek({6, 0});
        QVERIFY(sim::sameBits(track.state(), plain));
        QVERIFY(sim::sameBits(track.stateAt(6), plain));
        QCOMPARE(support::seekMismatch(script, std::size_t{1} << 24, 2, 12, 3), std::string());
    }

    void cancelledSeekStopsAfterTheCurrentStep()
    {
        const sim::Script script =
            support::script(bench::crowd::inTheRoom(1000), "semi_implicit_euler", 0.25);
        sim::Track track(script, std::size_t{1} << 24);
        QVERIFY(!track.interval().pipeline.blocks.empty());
        int calls = 0;
        QVERIFY(!track.seek({10, 0}, [&] { return ++calls < 7; })); // four steps per frame
        QCOMPARE(calls, 7);
        QVERIFY((track.cursor() == sim::Cursor{1, 0}));
        QVERIFY(track.seek({10, 0}, [] { return true; }));
        QVERIFY((track.cursor() == sim::Cursor{10, 0}));
    }
};

SUITE(tst_cache_blocks, TestCacheBlocks)
#include "tst_cache_blocks.moc"
