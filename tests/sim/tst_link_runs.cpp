// Links taken run by run: nothing is left out, the order of each point's pulls stays, and the sums have the very bits of
// a loop that takes link by link.

#include "support.h"

#include "sim/effects/body_spring.h"
#include "sim/effects/offset_spring.h"
#include "sim/effects/radial_spring.h"

#include <QTest>

#include <algorithm>
#include <cstring>

using namespace sim;
using support::Dice;

namespace {

constexpr double k = 0.3, rest = 40.0, scale = 0.7;

struct Layout
{
    const char *name;
    int points;
    std::vector<Link> links;
};

/// Creatures laid out foot by foot: all bodies, all first feet, and so on.
std::vector<Link> crowd(int creatures, int feet)
{
    std::vector<Link> links;
    for (int foot = 1; foot <= feet; ++foot) {
        for (int creature = 0; creature < creatures; ++creature)
            links.insert(links.end(),
                         {{foot * creatures + creature, creature}, {creature, foot * creatures + creature}});
    }
    return links;
}

std::vector<Link> chain(int points)
{
    std::vector<Link> links;
    for (int i = 1; i < points; ++i)
        links.insert(links.end(), {{i - 1, i}, {i, i - 1}});
    return links;
}

std::vector<Link> grid(int side)
{
    std::vector<Link> links;
    for (int i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            links.insert(links.end(), {{i, i + 1}, {i + 1, i}});
        if (i + side < side * side)
            links.insert(links.end(), {{i, i + side}, {i + side, i}});
    }
    return links;
}

/// Any two points; some links twice, some answered and some not.
std::vector<Link> anyhow(int points, int count, std::uint64_t seed)
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
    return {{"one creature", 6, support::legs(5)},
            {"a creature of three hundred feet", 301, support::legs(300)},
            {"one creature foot by foot", 6, crowd(1, 5)},
            {"two creatures foot by foot", 12, crowd(2, 5)},
            {"six hundred creatures foot by foot", 3600, crowd(600, 5)},
            {"a chain", 50, chain(50)},
            {"a grid", 400, grid(20)},
            {"few links anyhow", 10, anyhow(10, 12, 1)},
            {"many links anyhow", 40, anyhow(40, 500, 2)},
            {"no links", 5, {}}};
}

/// Scattered; here and there a handle, another mass, or two points in one place.
State stateOf(int points, std::uint64_t seed)
{
    Dice dice(seed);
    State state = State::ofPoints(points);
    state.acceleration.setZero(points, 2);
    for (int i = 0; i < points; ++i) {
        const int other = dice.whole(0, points - 1);
        if (dice.chance(0.05))
            state.place(i, state.at(other));
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

Vec2 radialPull(Vec2 mover, Vec2 anchor, Link link)
{
    const Vec2 from = {mover.x - anchor.x, mover.y - anchor.y};
    const double length = std::sqrt(from.x * from.x + from.y * from.y);
    Vec2 out = partingDirection(link.anchor, link.mover);
    if (length >= 1e-150)
        out = {from.x / length, from.y / length};
    return {k * (anchor.x + rest * out.x - mover.x), k * (anchor.y + rest * out.y - mover.y)};
}

Vec2 offsetPull(Vec2 mover, Vec2 anchor, Link)
{
    return {k * (anchor.x + rest - mover.x), k * (anchor.y - mover.y)};
}

Vec2 plainPull(Vec2 mover, Vec2 anchor, Link)
{
    return {k * (anchor.x - mover.x), k * (anchor.y - mover.y)};
}

using PullOf = Vec2 (*)(Vec2, Vec2, Link);

Eigen::ArrayX2d linkByLink(const std::vector<Link> &links, const State &state, Points movers, PullOf pullOf)
{
    Eigen::ArrayX2d sum = state.acceleration;
    for (const Link &link : links) {
        if (!movers.contains(link.mover) || state.inverseMass[link.mover] == 0.0)
            continue;
        const Vec2 pull = pullOf(state.at(link.mover), state.at(link.anchor), link);
        sum(link.mover, 0) += scale * (state.inverseMass[link.mover] * pull.x);
        sum(link.mover, 1) += scale * (state.inverseMass[link.mover] * pull.y);
    }
    return sum;
}

bool sameBits(const Eigen::ArrayX2d &a, const Eigen::ArrayX2d &b)
{
    return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

std::vector<Points> someOf(int points)
{
    return {{0, points}, {0, points / 2}, {points / 3, points / 3}, {points - 1, 1}, {1, points - 1}, {2, 0}};
}

/// The anchors of one mover, in order.
std::vector<int> anchorsOf(const std::vector<Link> &links, int mover)
{
    std::vector<int> anchors;
    for (const Link &link : links) {
        if (link.mover == mover)
            anchors.push_back(link.anchor);
    }
    return anchors;
}

std::vector<Link> inTheOrderTaken(const std::vector<Stroke> &strokes)
{
    std::vector<Link> links;
    for (const Stroke &stroke : strokes) {
        for (int i = 0; i < stroke.run.count; ++i)
            links.push_back(stroke.run.link(i));
        for (int i = 0; stroke.bothWays && i < stroke.run.count; ++i)
            links.push_back({stroke.run.link(i).anchor, stroke.run.link(i).mover});
    }
    return links;
}

}

class TestLinkRuns : public QObject
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
    void sumsHaveTheBitsOfALoopOverLinks_data() { addLayoutRows(); }
    void sumsHaveTheBitsOfALoopOverLinks()
    {
        QFETCH(int, index);
        const Layout given = layout(index);
        const RadialSpring radial(given.links, k, rest);
        const OffsetSpring offset(given.links, k, rest);
        const BodySpring plain(given.links, k);
        const std::vector<std::pair<const Force *, PullOf>> forces = {
            {&radial, radialPull}, {&offset, offsetPull}, {&plain, plainPull}};
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const State state = stateOf(given.points, seed);
            for (const Points movers : someOf(given.points)) {
                for (const auto &[force, pullOf] : forces) {
                    Eigen::ArrayX2d sum = state.acceleration;
                    force->add(state, movers, scale, Directions::apart, sum);
                    QVERIFY2(sameBits(sum, linkByLink(given.links, state, movers, pullOf)),
                             force->id().c_str());
                }
            }
        }
    }

    void partsInAscendingOrderComeToTheSameBits_data() { addLayoutRows(); }
    void partsInAscendingOrderComeToTheSameBits()
    {
        QFETCH(int, index);
        const Layout given = layout(index);
        const RadialSpring radial(given.links, k, rest);
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const State state = stateOf(given.points, seed);
            Dice dice(seed);
            Eigen::ArrayX2d sum = state.acceleration;
            for (int first = 0; first < given.points;) {
                const int count =
                    std::min(given.points - first, dice.whole(1, dice.chance(0.5) ? 3 : given.points));
                radial.addPart(state, {first, count}, scale, Directions::apart, sum);
                first += count;
            }
            QVERIFY(sameBits(sum, linkByLink(given.links, state, {0, given.points}, radialPull)));
        }
    }

    void partsTakeThePairsOfACrowdTogether()
    {
        const Links links(crowd(600, 5));
        int together = 0, alone = 0;
        for (const Points part : {Points{100, 200}, Points{700, 200}, Points{1300, 200}})
            links.runs().forEachPart(part, [&](const Stroke &stroke) {
                (stroke.bothWays ? together : alone) += stroke.run.count;
            });
        QCOMPARE(together, 400); // bodies have no link below them; two feet each have one
        QCOMPARE(alone, 0);
    }

    void everyLinkIsTakenOnceAndInItsPointsOrder_data() { addLayoutRows(); }
    void everyLinkIsTakenOnceAndInItsPointsOrder()
    {
        QFETCH(int, index);
        const Layout given = layout(index);
        const Links links(given.links);
        const std::vector<Link> taken = inTheOrderTaken(links.runs().strokes());
        QCOMPARE(taken.size(), given.links.size());
        for (int mover = 0; mover < given.points; ++mover)
            QCOMPARE(anchorsOf(taken, mover), anchorsOf(given.links, mover));
    }

    void waysThatAnswerEachOtherAreTakenTogether_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<std::size_t>("strokes");
        QTest::newRow("one creature") << 0 << std::size_t{1};
        QTest::newRow("a creature of three hundred feet") << 1 << std::size_t{2}; // 256 and 44
        QTest::newRow("one creature foot by foot") << 2 << std::size_t{1};
        QTest::newRow("two creatures foot by foot") << 3 << std::size_t{5};
        QTest::newRow("six hundred creatures foot by foot") << 4 << std::size_t{15}; // 256, 256 and 88
    }
    void waysThatAnswerEachOtherAreTakenTogether()
    {
        QFETCH(int, index);
        QFETCH(std::size_t, strokes);
        const Links links(layout(index).links);
        const std::vector<Stroke> &taken = links.runs().strokes();
        QCOMPARE(taken.size(), strokes);
        QVERIFY(std::all_of(taken.begin(), taken.end(), [](const Stroke &one) { return one.bothWays; }));
    }
};

QTEST_APPLESS_MAIN(TestLinkRuns)
#include "tst_link_runs.moc"
