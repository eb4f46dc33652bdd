// Forces between pairs of points. Each pair is computed exactly once, the order of a point's forces is kept,
// and the sums have the bits of a simple loop over the pairs.

#include "tests/sim/support/support.h"

#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cstring>

using namespace sim;
using support::Dice;

namespace {

constexpr double pairStiffness = 0.3, pairLength = 40.0;

struct Layout
{
    const char *name;
    int points;
    std::vector<Link> links;
};

std::vector<Link> randomLinks(int points, int count, std::uint64_t seed)
{
    Dice dice(seed);
    std::vector<Link> links;
    while (static_cast<int>(links.size()) < count) {
        const int a = dice.whole(0, points - 1), b = dice.whole(0, points - 1);
        if (a == b)
            continue;
        links.push_back({a, b});
        if (dice.chance(0.7))
            links.push_back({b, a});
        if (dice.chance(0.1))
            links.push_back({a, b});
    }
    return links;
}

std::vector<Layout> layouts()
{
    return {{"one creature", 6, scenes::legs(5)},
            {"a creature of three hundred feet", 301, scenes::legs(300)},
            {"one creature stored foot by foot", 6, scenes::legsByParts(1, 5)},
            {"two creatures stored foot by foot", 12, scenes::legsByParts(2, 5)},
            {"six hundred creatures stored foot by foot", 3600, scenes::legsByParts(600, 5)},
            {"a chain", 50, scenes::chainLinks(50)},
            {"a grid", 400, scenes::gridLinks(20)},
            {"few random links", 10, randomLinks(10, 12, 1)},
            {"many random links", 40, randomLinks(40, 500, 2)},
            {"no links", 5, {}}};
}

/// Returns random points, some of them fixed, coincident, or of different masses.
State stateOf(int points, std::uint64_t seed)
{
    Dice dice(seed);
    State state = State::ofPoints(points);
    state.acceleration.setZero(points, 2);
    for (int i = 0; i < points; ++i) {
        const int other = dice.whole(0, points - 1);
        if (dice.chance(0.05))
            state.place(i, state.positionOf(other));
        else if (dice.chance(0.05))
            state.place(i, {0.0, dice.chance(0.5) ? -0.0 : 80.0});
        else
            state.place(i, {dice.real(-100, 500), dice.real(-100, 500)});
        state.inverseMass[i] = dice.chance(0.1) ? 0.0 : dice.chance(0.3) ? dice.real(0.1, 3.0) : 1.0;
        state.acceleration(i, 0) = dice.chance(0.2) ? -0.0 : dice.real(-1, 1);
        state.acceleration(i, 1) = dice.real(-1, 1);
    }
    return state;
}

Vec2 radialForce(Vec2 mover, Vec2 anchor, Link link)
{
    const Vec2 from = {mover.x - anchor.x, mover.y - anchor.y};
    const double length = std::sqrt(from.x * from.x + from.y * from.y);
    if (length < 1e-150) {
        const Vec2 out = fallbackDirection(link.anchor, link.mover);
        return {pairStiffness * pairLength * out.x, pairStiffness * pairLength * out.y};
    }
    const double share = pairStiffness * (pairLength / length - 1.0);
    return {share * from.x, share * from.y};
}

Vec2 offsetForce(Vec2 mover, Vec2 anchor, Link)
{
    return {pairStiffness * (anchor.x + pairLength - mover.x), pairStiffness * (anchor.y - mover.y)};
}

Vec2 plainForce(Vec2 mover, Vec2 anchor, Link)
{
    return {pairStiffness * (anchor.x - mover.x), pairStiffness * (anchor.y - mover.y)};
}

using ForceOf = Vec2 (*)(Vec2, Vec2, Link);

/// A link, or two opposite links that are computed as one.
struct ExpectedPair
{
    Link link;
    bool bothWays = false; ///< whether the anchor feels the opposite force
};

/// Joins each link with its opposite link, if the forces of this kind are opposite (`areReciprocal`).
std::vector<ExpectedPair> pairsOf(const std::vector<Link> &links, bool areReciprocal)
{
    std::vector<ExpectedPair> pairs;
    for (const Link &link : links) {
        const auto back = std::find_if(pairs.begin(), pairs.end(), [&](const ExpectedPair &pair) {
            return areReciprocal && !pair.bothWays && pair.link.mover == link.anchor &&
                   pair.link.anchor == link.mover;
        });
        if (back == pairs.end())
            pairs.push_back({link});
        else
            back->bothWays = true;
    }
    return pairs;
}

Eigen::ArrayX2d sumPairByPair(const std::vector<ExpectedPair> &pairs, const State &state, PointRange range,
                              double scale, ForceOf forceOf)
{
    Eigen::ArrayX2d sum = state.acceleration;
    const auto add = [&](int point, Vec2 pull) {
        if (!range.contains(point) || state.inverseMass[point] == 0.0)
            return;
        sum(point, 0) += scale * (state.inverseMass[point] * pull.x);
        sum(point, 1) += scale * (state.inverseMass[point] * pull.y);
    };
    for (const auto &[link, bothWays] : pairs) {
        const Vec2 pull = forceOf(state.positionOf(link.mover), state.positionOf(link.anchor), link);
        add(link.mover, pull);
        if (bothWays)
            add(link.anchor, {-pull.x, -pull.y});
    }
    return sum;
}

bool sameAccelerations(const Eigen::ArrayX2d &a, const Eigen::ArrayX2d &b)
{
    return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

std::vector<PointRange> someRanges(int points)
{
    return {{0, points}, {0, points / 2}, {points / 3, points / 3}, {points - 1, 1}, {1, points - 1}, {2, 0}};
}

Links linksOf(const std::vector<Link> &links)
{
    return {sim::pairsOf(links), true, [](int, int) { return true; }};
}

/// Returns the points to which `point` has a force, in order.
std::vector<int> partnersOf(const std::vector<PointPair> &pairs, int point)
{
    std::vector<int> others;
    for (const PointPair &pair : pairs) {
        if (pair.mover == point)
            others.push_back(pair.anchor);
        else if (pair.anchor == point && pair.isReciprocal)
            others.push_back(pair.mover);
    }
    return others;
}

std::string shapesOf(const PairList &list)
{
    std::string shapes;
    for (const PairBatch &batch : list.batches) {
        const char *shape = batch.shape == PairBatch::Shape::row   ? "row "
                            : batch.shape == PairBatch::Shape::fan ? "fan "
                                                                   : "list ";
        shapes += (shapes.empty() ? "" : ", ") + (shape + std::to_string(batch.count));
    }
    return shapes;
}

}

class TestPairForces : public QObject
{
    Q_OBJECT

    static void addLayoutRows()
    {
        QTest::addColumn<int>("index");
        const std::vector<Layout> all = layouts();
        for (std::size_t i = 0; i < all.size(); ++i)
            QTest::newRow(all[i].name) << static_cast<int>(i);
    }

    static Layout layout(int index) { return layouts()[static_cast<std::size_t>(index)]; }

private slots:
    void sumsHaveTheBitsOfALoopOverPairs_data() { addLayoutRows(); }
    void sumsHaveTheBitsOfALoopOverPairs()
    {
        QFETCH(int, index);
        const Layout given = layout(index);
        const RadialSpring radial(given.links, pairStiffness, pairLength);
        const OffsetSpring offset(given.links, pairStiffness, pairLength);
        const BodySpring plain(given.links, pairStiffness);
        struct Case
        {
            const Force *force;
            ForceOf forceOf;
            std::vector<ExpectedPair> pairs;
        };
        const std::vector<Case> cases = {{&radial, radialForce, pairsOf(given.links, true)},
                                         {&offset, offsetForce, pairsOf(given.links, false)},
                                         {&plain, plainForce, pairsOf(given.links, true)}};
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            State state = stateOf(given.points, seed);
            if (seed % 2 == 0)
                state.inverseMass.setOnes(); // the loops have a branch for equal masses
            for (const PointRange range : someRanges(given.points)) {
                for (const double scale : {1.0, 0.7}) {
                    for (const Case &testCase : cases) {
                        Eigen::ArrayX2d sum = state.acceleration;
                        testCase.force->add(state, range, scale, DirectionRule::regularised, sum);
                        QVERIFY2(sameAccelerations(sum, sumPairByPair(testCase.pairs, state, range, scale,
                                                                      testCase.forceOf)),
                                 testCase.force->id().c_str());
                    }
                }
            }
        }
    }

    void separateIslandsHaveTheSameBits()
    {
        const int creatures = 40;
        const std::vector<Link> links = scenes::legsByParts(creatures, 5);
        const RadialSpring radial(links, pairStiffness, pairLength);
        const State state = stateOf(6 * creatures, 3);
        Eigen::ArrayX2d allAtOnce = state.acceleration, blockByBlock = state.acceleration;
        radial.adderFor({{0, 6 * creatures}})(state, allAtOnce);
        for (int first = 0; first < creatures; first += 8) {
            std::vector<PointRange> ranges;
            for (int foot = 0; foot < 6; ++foot)
                ranges.push_back({foot * creatures + first, 8});
            radial.adderFor(ranges)(state, blockByBlock);
        }
        QVERIFY(sameAccelerations(allAtOnce, blockByBlock));
    }

    void bothEndsFeelExactlyOppositeForces()
    {
        Dice dice(7);
        for (int run = 0; run < 2000; ++run) {
            State state = State::ofPoints(2);
            const double size = std::pow(10.0, dice.real(-160.0, 150.0));
            state.place(0, {size * dice.real(-1, 1), size * dice.real(-1, 1)});
            state.place(1, dice.chance(0.1) ? state.positionOf(0)
                                            : Vec2{size * dice.real(-1, 1), size * dice.real(-1, 1)});
            const RadialSpring spring({{0, 1}, {1, 0}}, dice.real(0.0, 10.0), dice.real(0.0, 90.0));
            Eigen::ArrayX2d pull = Eigen::ArrayX2d::Zero(2, 2);
            spring.add(state, {0, 2}, 1.0, DirectionRule::regularised, pull);
            QVERIFY(pull.isFinite().all());
            QVERIFY((pull.row(0) == -pull.row(1)).all()); // or momentum would not be conserved
        }
    }

    void batchesKeepEachPairOnceAndTheOrderPerPoint_data() { addLayoutRows(); }
    void batchesKeepEachPairOnceAndTheOrderPerPoint()
    {
        QFETCH(int, index);
        const Layout given = layout(index);
        const Links links = linksOf(given.links);
        const PairList list = links.batches({{0, given.points}}, true);
        QCOMPARE(list.pairs.size(), links.pairs().size());
        int covered = 0;
        for (const PairBatch &batch : list.batches) {
            QCOMPARE(batch.first, covered);
            covered += batch.count;
        }
        QCOMPARE(covered, static_cast<int>(list.pairs.size()));
        for (int point = 0; point < given.points; ++point)
            QCOMPARE(partnersOf(list.pairs, point), partnersOf(links.pairs(), point));
    }

    void regularPairsRunInBatches_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("shapes");
        QTest::newRow("one creature") << 0 << "fan 5";
        QTest::newRow("a creature of three hundred feet") << 1 << "fan 300";
        QTest::newRow("one creature stored foot by foot") << 2 << "fan 5";
        QTest::newRow("two creatures stored foot by foot") << 3 << "list 10"; // too few for a row batch
        QTest::newRow("six hundred creatures stored foot by foot")
            << 4 << "row 600, row 600, row 600, row 600, row 600";
        QTest::newRow("a chain") << 5 << "row 49";
    }
    void regularPairsRunInBatches()
    {
        QFETCH(int, index);
        QFETCH(QString, shapes);
        const Links links = linksOf(layout(index).links);
        QCOMPARE(shapesOf(links.batches({{0, layout(index).points}}, true)), shapes.toStdString());
    }
};

SUITE(tst_pair_forces, TestPairForces)
#include "tst_pair_forces.moc"
