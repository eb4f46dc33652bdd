#include "support.h"

#include "tests/bench/crowd.h"

#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/scene/islands.h"

#include <QTest>

namespace {

using Runs = std::vector<sim::PointRange>;

/// `points` points with springs between some, and nothing else.
sim::Scene sprung(int points, const std::vector<sim::Link> &links)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(points);
    scene.groups = {{"all", {0, points}}};
    scene.effects = {std::make_shared<sim::BodySpring>(links, 0.1), std::make_shared<sim::Gravity>(0.5)};
    return scene;
}

/// For each two points whether springs lead from one to the other: by squaring the table of neighbours until it
/// stays as it is.
std::vector<std::vector<bool>> reach(int points, const std::vector<sim::Link> &links)
{
    const auto size = static_cast<std::size_t>(points);
    std::vector<std::vector<bool>> reaches(size, std::vector<bool>(size, false));
    for (std::size_t i = 0; i < size; ++i)
        reaches[i][i] = true;
    for (const sim::Link &link : links) {
        const auto a = static_cast<std::size_t>(link.mover), b = static_cast<std::size_t>(link.anchor);
        reaches[a][b] = reaches[b][a] = true;
    }
    for (std::size_t by = 0; by < size; ++by)
        for (std::size_t a = 0; a < size; ++a)
            for (std::size_t b = 0; b < size; ++b)
                reaches[a][b] = reaches[a][b] || (reaches[a][by] && reaches[by][b]);
    return reaches;
}

}

/// Which parts of a scene nothing ties to each other.
class Islands : public QObject
{
    Q_OBJECT

private slots:
    void eachCreatureOfACrowdIsOne()
    {
        const auto islands = sim::islandsOf(bench::crowd::inTheRoom(7));
        QCOMPARE(islands.size(), std::size_t{7});
        for (int creature = 0; creature < 7; ++creature) {
            const Runs &runs = islands[static_cast<std::size_t>(creature)];
            QCOMPARE(runs.size(), std::size_t{6});
            for (int foot = -1; foot < 5; ++foot) {
                const sim::PointRange range = runs[static_cast<std::size_t>(foot + 1)];
                QCOMPARE(range.first, bench::crowd::pointOf(7, creature, foot));
                QCOMPARE(range.count, 1);
            }
        }
    }

    void twoPointsShareOneIfSpringsLeadFromOneToTheOther_data()
    {
        QTest::addColumn<int>("links");
        for (const int links : {0, 5, 20, 35, 60})
            QTest::addRow("%d springs", links) << links;
    }
    void twoPointsShareOneIfSpringsLeadFromOneToTheOther()
    {
        QFETCH(int, links);
        constexpr int points = 50;
        support::Dice dice(static_cast<std::uint64_t>(links));
        std::vector<sim::Link> springs;
        for (int i = 0; i < links; ++i)
            springs.push_back({dice.whole(0, points - 1), dice.whole(0, points - 1)});
        const auto islands = sim::islandsOf(sprung(points, springs));
        std::vector<int> islandOf(points, -1);
        int before = -1;
        for (std::size_t island = 0; island < islands.size(); ++island) {
            QVERIFY(islands[island].front().first > before); // in order of their lowest points
            before = islands[island].front().first;
            int end = -1;
            for (const sim::PointRange &range : islands[island]) {
                QVERIFY(range.count > 0 && range.first > end); // apart: neighbours are one run
                end = range.end();
                for (int i = range.first; i < range.end(); ++i) {
                    QCOMPARE(islandOf[static_cast<std::size_t>(i)], -1);
                    islandOf[static_cast<std::size_t>(i)] = static_cast<int>(island);
                }
            }
        }
        const auto reaches = reach(points, springs);
        for (std::size_t a = 0; a < points; ++a) {
            for (std::size_t b = 0; b < points; ++b)
                QCOMPARE(islandOf[a] == islandOf[b], bool(reaches[a][b]));
        }
    }

    void whatSeesTheSceneMakesOneOfAll()
    {
        sim::Scene scene = sprung(4, {{0, 1}, {2, 3}});
        QCOMPARE(sim::islandsOf(scene).size(), std::size_t{2});
        scene.effects.push_back(std::make_shared<sim::GaitClock>());
        QCOMPARE(sim::islandsOf(scene).size(), std::size_t{2}); // no clock to turn
        scene.start.gait.setZero(1);
        scene.start.gaitSpeed.setZero(1);
        const auto islands = sim::islandsOf(scene);
        QCOMPARE(islands.size(), std::size_t{1});
        QCOMPARE(islands[0].size(), std::size_t{1});
        QCOMPARE(islands[0][0].count, 4);
    }

    void pointsThatPushEachOtherAreOne()
    {
        sim::Scene scene = sprung(6, {{0, 1}, {2, 3}});
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

QTEST_GUILESS_MAIN(Islands)
#include "tst_islands.moc"
