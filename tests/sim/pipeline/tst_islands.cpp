#include "tests/sim/support/support.h"

#include "tests/bench/scenes/crowd.h"

#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/scene/islands.h"
#include "tests/suite.h"

#include <QTest>

namespace {

using Ranges = std::vector<sim::PointRange>;

/// Returns `points` points with springs and gravity.
sim::Scene pointsWithSprings(int points, const std::vector<sim::Link> &links)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(points);
    scene.groups = {{"all", {0, points}}};
    scene.effects = {std::make_shared<sim::BodySpring>(links, 0.1), std::make_shared<sim::Gravity>(0.5)};
    return scene;
}

/// Returns for each pair of points whether springs connect them, by Warshall's algorithm.
std::vector<std::vector<bool>> connectivity(int points, const std::vector<sim::Link> &links)
{
    const auto size = static_cast<std::size_t>(points);
    std::vector<std::vector<bool>> connected(size, std::vector<bool>(size, false));
    for (std::size_t i = 0; i < size; ++i)
        connected[i][i] = true;
    for (const sim::Link &link : links) {
        const auto a = static_cast<std::size_t>(link.mover), b = static_cast<std::size_t>(link.anchor);
        connected[a][b] = connected[b][a] = true;
    }
    for (std::size_t via = 0; via < size; ++via)
        for (std::size_t a = 0; a < size; ++a)
            for (std::size_t b = 0; b < size; ++b)
                connected[a][b] = connected[a][b] || (connected[a][via] && connected[via][b]);
    return connected;
}

}

/// The islands of a scene: points that no coupling joins to others.
class TestIslands : public QObject
{
    Q_OBJECT

private slots:
    void eachCreatureOfACrowdIsAnIsland()
    {
        const auto islands = sim::islandsOf(bench::crowd::inTheRoom(7));
        QCOMPARE(islands.size(), std::size_t{7});
        for (int creature = 0; creature < 7; ++creature) {
            const Ranges &ranges = islands[static_cast<std::size_t>(creature)];
            QCOMPARE(ranges.size(), std::size_t{6});
            for (int foot = -1; foot < 5; ++foot) {
                const sim::PointRange range = ranges[static_cast<std::size_t>(foot + 1)];
                QCOMPARE(range.first, bench::crowd::pointOf(7, creature, foot));
                QCOMPARE(range.count, 1);
            }
        }
    }

    void pointsShareAnIslandIfSpringsConnectThem_data()
    {
        QTest::addColumn<int>("links");
        for (const int links : {0, 5, 20, 35, 60})
            QTest::addRow("%d springs", links) << links;
    }
    void pointsShareAnIslandIfSpringsConnectThem()
    {
        QFETCH(int, links);
        constexpr int points = 50;
        support::Dice dice(static_cast<std::uint64_t>(links));
        std::vector<sim::Link> springs;
        for (int i = 0; i < links; ++i)
            springs.push_back({dice.whole(0, points - 1), dice.whole(0, points - 1)});
        const auto islands = sim::islandsOf(pointsWithSprings(points, springs));
        std::vector<int> islandOf(points, -1);
        int before = -1;
        for (std::size_t island = 0; island < islands.size(); ++island) {
            QVERIFY(islands[island].front().first > before); // in order of their lowest points
            before = islands[island].front().first;
            int end = -1;
            for (const sim::PointRange &range : islands[island]) {
                QVERIFY(range.count > 0 && range.first > end); // neighbours are in one range
                end = range.end();
                for (int i = range.first; i < range.end(); ++i) {
                    QCOMPARE(islandOf[static_cast<std::size_t>(i)], -1);
                    islandOf[static_cast<std::size_t>(i)] = static_cast<int>(island);
                }
            }
        }
        const auto connected = connectivity(points, springs);
        for (std::size_t a = 0; a < points; ++a) {
            for (std::size_t b = 0; b < points; ++b)
                QCOMPARE(islandOf[a] == islandOf[b], bool(connected[a][b]));
        }
    }

    void effectThatDependsOnTheSceneJoinsAllPoints()
    {
        sim::Scene scene = pointsWithSprings(4, {{0, 1}, {2, 3}});
        QCOMPARE(sim::islandsOf(scene).size(), std::size_t{2});
        scene.effects.push_back(std::make_shared<sim::GaitClock>());
        QCOMPARE(sim::islandsOf(scene).size(), std::size_t{2}); // the scene has no clocks
        scene.start.gait.setZero(1);
        scene.start.gaitSpeed.setZero(1);
        const auto islands = sim::islandsOf(scene);
        QCOMPARE(islands.size(), std::size_t{1});
        QCOMPARE(islands[0].size(), std::size_t{1});
        QCOMPARE(islands[0][0].count, 4);
    }

    void pointsThatPushEachOtherShareAnIsland()
    {
        sim::Scene scene = pointsWithSprings(6, {{0, 1}, {2, 3}});
        scene.effects.push_back(
            std::make_shared<sim::Push>(std::vector<int>{1, 2, 5}, 0.1, 30.0, sim::Reaction::equal));
        const auto islands = sim::islandsOf(scene);
        QCOMPARE(islands.size(), std::size_t{2});
        QCOMPARE(islands[0].size(), std::size_t{2}); // 0 to 3, and 5
        QCOMPARE(islands[0][0].count, 4);
        QCOMPARE(islands[0][1].first, 5);
        QCOMPARE(islands[1][0].first, 4);
    }
};

SUITE(tst_islands, TestIslands)
#include "tst_islands.moc"
