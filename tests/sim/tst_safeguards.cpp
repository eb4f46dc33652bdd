// What keeps runs whole where they would break: each safeguard beside what happens without it.

#include "support.h"

#include "sim/direction.h"
#include "sim/effects/area_stick.h"
#include "sim/effects/radial_spring.h"
#include "sim/effects/sticks.h"
#include "sim/effects/tree_wind.h"
#include "sim/error.h"
#include "sim/hard/scenes.h"
#include "sim/methods/methods.h"
#include "sim/methods/newton.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace sim;

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

std::string refusalOf(const Script &script)
{
    try {
        Track(script, 0);
    } catch (const Error &error) {
        return error.id();
    }
    return {};
}

/// How far the sticks of a chain are wrong at the worst after its last point went 5 px along.
double worstAfterPull(Sweep sweep)
{
    const int links = 100;
    Scene scene = support::pointsOf(links);
    std::vector<Stick> sticks;
    for (int i = 0; i <= links; ++i)
        scene.start.place(i, {10.0 * i, 200.0});
    for (int i = 0; i < links; ++i)
        sticks.push_back({i, i + 1, 10.0});
    scene.start.place(links, {10.0 * links + 5.0, 200.0});
    scene.start.inverseMass[links] = 0.0; // the hand
    const Sticks chain(sticks, links + 1, 40, sweep);
    chain.enforce(scene.start, {0, links + 1}, Directions::apart, 1.0);
    double worst = 0.0;
    for (const Stick &one : sticks)
        worst = std::max(worst, std::abs(length(scene.start.at(one.a) - scene.start.at(one.b)) - one.length));
    return worst;
}

/// A crowd in one place under backward Euler: what is missing in its equation after a step of one frame, as the most that
/// any velocity is off, px/frame. And what that took.
struct Solved
{
    double off = 0.0;
    std::int64_t evaluations = 0;
};

Solved burstApart(Effort effort)
{
    const double k = 1.0, radius = 50.0;
    Scene scene = support::pointsOf(5);
    scene.effects = {std::make_shared<RadialSpring>(support::legs(5), k, radius)};
    findMethod("backward_euler")->prepare(scene.start);
    const Equations equations(scene, Directions::apart);
    State state = scene.start;
    ImplicitStep step(equations, state, effort);
    const Numbers from = step.motion.x, drift = step.motion.v;
    const Numbers u = step.solve(from, drift, 1.0);
    const std::int64_t evaluations = state.evaluations;
    const Numbers off = u - drift - step.pulls(from + u);
    return {off.abs().maxCoeff(), evaluations};
}

}

class TestSafeguards : public QObject
{
    Q_OBJECT

private slots:
    void aHandThatIsNowhereIsRefused_data();
    void aHandThatIsNowhereIsRefused();
    void aHandThatIsNowhereLeavesTheRunAsItWas();
    void withoutThatRefusalAllIsNowhere();
    void pointsInOnePlaceHaveADirection();
    void windWithoutADistanceTurnsNoFartherThanTheWind();
    void aSpineWithoutALengthHasAWidth();
    void sticksAreGoneThroughBothWays();
    void sticksGoneThroughForthKeepTheirBits();
    void aCrowdBurstsOutOfOnePlace();
    void aSolutionThatIsNotThereIsNotLookedForForEver();
};

void TestSafeguards::aHandThatIsNowhereIsRefused_data()
{
    QTest::addColumn<double>("number");
    QTest::newRow("not a number") << noNumber;
    QTest::newRow("infinite") << infinite;
    QTest::newRow("infinite the other way") << -infinite;
}

void TestSafeguards::aHandThatIsNowhereIsRefused()
{
    QFETCH(double, number);
    const Vec2 place = {270.0, number};
    for (const Event &event :
         {Event{3, Move{place}}, Event{3, Pointer{place, true}}, Event{3, Target{place}},
          Event{3, Gust{number}}, Event{3, Set{"k", number}}, Event{3, Move{{number, 200.0}}}}) {
        Script script = support::script(support::sample("spring to a point"), "published");
        script.input = {event};
        QCOMPARE(refusalOf(script), std::string("input-not-finite"));
    }
    Script script = support::script(support::sample("spring to a point"), "published");
    script.input = {{3, Move{{270.0, 1e300}}}};
    QCOMPARE(refusalOf(script), std::string());
}

void TestSafeguards::aHandThatIsNowhereLeavesTheRunAsItWas()
{
    Timeline timeline(support::script(support::sample("spring to a point"), "published"));
    timeline.hand(Grab{"foot"});
    timeline.seek({5, 0});
    const State before = timeline.now();
    try {
        timeline.hand(Move{{noNumber, 200.0}});
        QFAIL("it was let through");
    } catch (const Error &error) {
        QCOMPARE(error.values().at("event"), std::string("move"));
        QCOMPARE(error.values().at("frame"), std::string("6"));
    }
    QCOMPARE(timeline.script().input.size(), std::size_t(1));
    QVERIFY(sameBits(timeline.now(), before));
    QVERIFY(!timeline.ghost());
}

void TestSafeguards::withoutThatRefusalAllIsNowhere()
{
    const Scene scene = support::sample("heavy pair").build(support::sample("heavy pair").values);
    State state = scene.start;
    const MethodPtr method = findMethod("semi_implicit_euler");
    method->prepare(state);
    const Pipeline pipeline = compose(scene, *method, StepSize::of(1.0));
    state.place(0, {noNumber, 200.0}); // as the hand would
    for (const Phase &phase : pipeline.phases)
        phase.run(state);
    QCOMPARE(firstNotFinite(state), 0);
    QVERIFY(!std::isfinite(state.at(1).x)); // and what is tied to it
}

void TestSafeguards::pointsInOnePlaceHaveADirection()
{
    const Vec2 d = {0.0, 0.0};
    QVERIFY(std::isnan(d.x / length(d))); // without the rule
    const Vec2 out = direction(d, 3, 4).out, back = direction(d, 4, 3).out;
    QVERIFY(std::abs(length(out) - 1.0) < 1e-15);
    QCOMPARE(out.x, -back.x);
    QCOMPARE(out.y, -back.y);
}

void TestSafeguards::windWithoutADistanceTurnsNoFartherThanTheWind()
{
    const double strength = byDistance(0.0);
    QVERIFY(!std::isfinite(bendPublished(0.0, 90.0, strength, 1.0))); // without the bound
    QCOMPARE(bend(0.0, 90.0, strength, 1.0), 90.0);
}

void TestSafeguards::aSpineWithoutALengthHasAWidth()
{
    const Heading none = {0.0, {1.0, 0.0}};
    const Vec2 left = {0.0, -5.0}, right = {0.0, 5.0};
    QVERIFY(!std::isfinite(keepArea(left, right, none, 400.0, 0.0, 0.5).wanted)); // without a shortest spine
    QCOMPARE(keepArea(left, right, none, 400.0, 10.0, 0.5).wanted, 80.0);
}

void TestSafeguards::sticksAreGoneThroughBothWays()
{
    // Forth alone, what the hand does at the end of the list gets a stick nearer to its start each time, so that it is
    // shared by as many sticks as there are passes; both ways it is passed on in one.
    const double forth = worstAfterPull(Sweep::forth);
    const double both = worstAfterPull(Sweep::forthAndBack);
    qInfo("worst stick: %g px forth, %g px both ways", forth, both);
    QVERIFY(both < 0.5 * forth);
}

void TestSafeguards::sticksGoneThroughForthKeepTheirBits()
{
    const std::vector<Stick> sticks = {{0, 1, 40.0}, {1, 2, 40.0}, {0, 2, 40.0}};
    Scene scene = support::pointsOf(2);
    support::scatter(scene.start, 5, 100.0);
    State state = scene.start;
    Sticks(sticks, 3, 3).enforce(state, {0, 3}, Directions::apart, 1.0);
    State plain = scene.start;
    for (int pass = 0; pass < 3; ++pass) {
        for (const Stick &one : sticks) {
            const Vec2 a = plain.at(one.a), b = plain.at(one.b);
            const StickEnds ends = stick(a, b, direction(a - b, one.b, one.a), one.length, one.share);
            plain.place(one.a, ends.a);
            plain.place(one.b, ends.b);
        }
    }
    QVERIFY(sameBits(state, plain));
}

void TestSafeguards::aCrowdBurstsOutOfOnePlace()
{
    const Solved without = burstApart({20, 0});
    const Solved with = burstApart({});
    qInfo("off by %g px/frame without, %g with", without.off, with.off);
    QVERIFY(without.off > 1e-3);
    QVERIFY(with.off < 1e-9);
}

void TestSafeguards::aSolutionThatIsNotThereIsNotLookedForForEver()
{
    const Effort few = {5, 10}, more = {5, 20};
    QVERIFY(burstApart(few).evaluations <= 5 * 8 + 10 + 4);
    QVERIFY(burstApart(more).evaluations > burstApart(few).evaluations || burstApart(few).off < 1e-9);
}

QTEST_GUILESS_MAIN(TestSafeguards)
#include "tst_safeguards.moc"
