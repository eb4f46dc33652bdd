// What keeps runs whole where they would break: each safeguard beside what happens without it.

#include "sim/pipeline/pipeline.h"
#include "sim/run/finite.h"
#include "support.h"

#include "sim/base/direction.h"
#include "sim/base/error.h"
#include "sim/catalogue/scenes.h"
#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/methods/implicit/newton.h"
#include "sim/methods/implicit/solvers/semidefinite.h"
#include "sim/methods/methods.h"

#include <Eigen/Eigenvalues>

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

/// A first step of backward Euler, of one frame, for `feet` feet `out` px from their body on springs of 50 px: by how
/// much the velocities that it found miss its equation at the most, px/frame, and what that took.
struct Solved
{
    double off = 0.0;
    std::int64_t evaluations = 0;
};

Solved burstApart(double k, int feet, double out, JacobianKind effort)
{
    Scene scene = hard::creature(
        hard::valuesOf({{"k", k}, {"damp", 0.9}, {"radius", 50}, {"feet", double(feet)}, {"out", out}}));
    findMethod("backward_euler")->prepareState(scene.start);
    const Equations equations(scene, DirectionRule::regularised);
    State state = scene.start;
    ImplicitStep step(equations, state, effort);
    const Numbers from = step.motion.x, drift = step.motion.v, share = step.kept(1.0);
    const Numbers u = step.solve(from, drift, 1.0, share);
    const auto evaluations = static_cast<std::int64_t>(state.forceEvaluations());
    const Numbers off = u - drift - share * step.pulls(from + u);
    return {off.abs().maxCoeff(), evaluations};
}

/// How pulls between two points change when a spring between them is pressed together to half its length.
Jacobian pressedTogether()
{
    Jacobian jacobian(2);
    const Vec2 from = {15.0, 20.0};
    addPairJacobian(jacobian, 0, 1, radialSpringJacobian(from, 1.0, 50.0));
    addPairJacobian(jacobian, 1, 0, radialSpringJacobian(-1.0 * from, 1.0, 50.0));
    return jacobian;
}

/// The least eigenvalue of 1 less what `entries` make up.
double leastOf(const std::vector<Jacobian::Entry> &entries)
{
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (const Jacobian::Entry &entry : entries)
        matrix(entry.row, entry.column) -= entry.value;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(matrix).eigenvalues().minCoeff();
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
    void aStartThatIsNowhereIsRefused_data();
    void aStartThatIsNowhereIsRefused();
    void pointsInOnePlaceHaveADirection();
    void windWithoutADistanceTurnsNoFartherThanTheWind();
    void aSpineWithoutALengthHasAWidth();
    void aCrowdBurstsOutOfOnePlace_data();
    void aCrowdBurstsOutOfOnePlace();
    void moreOfNewtonsMethodIsNoHelp();
    void slopesThatPushAreLeftOut();
    void slopesThatPullStayAsTheyAre();
    void slopesThatTurnLoseOnlyTheirPush_data();
    void slopesThatTurnLoseOnlyTheirPush();
    void anySlopeLosesItsPushAndNothingElse();
    void aSolutionThatIsNotFoundIsNotLookedForForEver();
    void whereEveryWayLeadsOutOfTheNumbersStandingStillIsNoAnswer_data();
    void whereEveryWayLeadsOutOfTheNumbersStandingStillIsNoAnswer();
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
    timeline.applyInput(Grab{"foot"});
    timeline.seek({5, 0});
    const State before = timeline.state();
    try {
        timeline.applyInput(Move{{noNumber, 200.0}});
        QFAIL("it was let through");
    } catch (const Error &error) {
        QCOMPARE(error.values().at("event"), std::string("move"));
        QCOMPARE(error.values().at("frame"), std::string("6"));
    }
    QCOMPARE(timeline.script().input.size(), std::size_t(1));
    QVERIFY(sameBits(timeline.state(), before));
    QVERIFY(!timeline.comparison());
}

void TestSafeguards::withoutThatRefusalAllIsNowhere()
{
    const Scene scene = support::sample("heavy pair").build(support::sample("heavy pair").values);
    State state = scene.start;
    const MethodPtr method = findMethod("semi_implicit_euler");
    method->prepareState(state);
    const Pipeline pipeline = compose(scene, *method, StepSize::ofLength(1.0));
    state.place(0, {noNumber, 200.0}); // as the hand would
    for (const Phase &phase : pipeline.phases)
        phase.run(state);
    QCOMPARE(firstNonFinitePoint(state), 0);
    QVERIFY(!std::isfinite(state.positionOf(1).x)); // and what is tied to it
}

void TestSafeguards::aStartThatIsNowhereIsRefused_data()
{
    aHandThatIsNowhereIsRefused_data();
}

void TestSafeguards::aStartThatIsNowhereIsRefused()
{
    QFETCH(double, number);
    const auto refusal = [](const BodyStart &start) {
        Script script = support::script(support::sample("heavy pair"), "semi_implicit_euler");
        const std::string name = script.build(script.values).names.at(1);
        script.bodies[name] = start;
        try {
            Track(script, 0);
        } catch (const Error &error) {
            return error.id() + (error.values().at("body") == name ? ", by name" : "");
        }
        return std::string();
    };
    QCOMPARE(refusal({{number, 200.0}, {}}), std::string("start-not-finite, by name"));
    QCOMPARE(refusal({{270.0, number}, {}}), std::string("start-not-finite, by name"));
    QCOMPARE(refusal({{270.0, 200.0}, Vec2{number, 0.0}}), std::string("start-not-finite, by name"));
    QCOMPARE(refusal({{270.0, 200.0}, Vec2{1.0, 0.0}}), std::string());
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
    const Direction none = {0.0, {1.0, 0.0}};
    const Vec2 left = {0.0, -5.0}, right = {0.0, 5.0};
    QVERIFY(!std::isfinite(keepArea(left, right, none, 400.0, 0.0, 0.5).wanted)); // without a shortest spine
    QCOMPARE(keepArea(left, right, none, 400.0, 10.0, 0.5).wanted, 80.0);
}

void TestSafeguards::aCrowdBurstsOutOfOnePlace_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<int>("feet");
    QTest::addColumn<double>("out");
    QTest::newRow("soft, in one place") << 0.1 << 15 << 0.0;
    QTest::newRow("in one place") << 1.0 << 20 << 0.0;
    QTest::newRow("stiff, in one place") << 1e4 << 12 << 0.0;
    QTest::newRow("stiff, nearly in one place") << 1e4 << 40 << 0.001;
    QTest::newRow("stiff, within one px") << 1e6 << 12 << 1.0;
}

void TestSafeguards::aCrowdBurstsOutOfOnePlace()
{
    QFETCH(double, k);
    QFETCH(int, feet);
    QFETCH(double, out);
    const Solved without = burstApart(k, feet, out, {20, 0});
    const Solved with = burstApart(k, feet, out, {});
    QVERIFY2(without.off > 0.1, qPrintable(QString::number(without.off)));
    // To some digits before the last one of k times 50 px.
    QVERIFY2(with.off < 1e-8 + 1e-14 * k * 50.0 * feet, qPrintable(QString::number(with.off)));
}

void TestSafeguards::moreOfNewtonsMethodIsNoHelp()
{
    QVERIFY(burstApart(1e4, 12, 0.0, {1000, 0}).off > 0.1);
}

void TestSafeguards::slopesThatPushAreLeftOut()
{
    // Across a spring of half its length the slope is k (50 / 25 - 1), for each end; so 1 - 2 in the matrix.
    const Jacobian jacobian = pressedTogether();
    QVERIFY(std::abs(leastOf(jacobian.entries()) - (1.0 - 2.0)) < 1e-12);
    QVERIFY(std::abs(leastOf(nearestNegativeSemidefiniteBlocks(jacobian, 2)) - 1.0) < 1e-12);
}

void TestSafeguards::slopesThatPullStayAsTheyAre()
{
    Jacobian jacobian(2);
    addPairJacobian(jacobian, 0, 1, radialSpringJacobian({60.0, 80.0}, 1.0, 50.0));
    jacobian.addAngular(0, 1, 3.0);
    const std::vector<Jacobian::Entry> calm = nearestNegativeSemidefiniteBlocks(jacobian, 2);
    QCOMPARE(calm.size(), jacobian.entries().size());
    for (std::size_t i = 0; i < calm.size(); ++i)
        QCOMPARE(calm[i].value, jacobian.entries()[i].value);
}

void TestSafeguards::slopesThatTurnLoseOnlyTheirPush_data()
{
    QTest::addColumn<PairJacobian>("jacobian");
    QTest::addColumn<PairJacobian>("kept");
    QTest::newRow("it only turns") << PairJacobian{0, 3, -3, 0} << PairJacobian{0, 3, -3, 0};
    QTest::newRow("it pulls and turns") << PairJacobian{-2, 3, -3, -1} << PairJacobian{-2, 3, -3, -1};
    QTest::newRow("it pushes along y and turns") << PairJacobian{-2, 3, -3, 1} << PairJacobian{-2, 3, -3, 0};
    QTest::newRow("it pushes along x and turns") << PairJacobian{4, 3, -3, -1} << PairJacobian{0, 3, -3, -1};
    QTest::newRow("it pushes everywhere and turns") << PairJacobian{1, 3, -3, 2} << PairJacobian{0, 3, -3, 0};
    // The symmetric part is (-1, 2; 2, -1): 1 along (1, 1), and -3 across.
    QTest::newRow("it pushes along a diagonal and turns")
        << PairJacobian{-1, 2.5, 1.5, -1} << PairJacobian{-1.5, 2, 1, -1.5};
}

void TestSafeguards::slopesThatTurnLoseOnlyTheirPush()
{
    QFETCH(PairJacobian, jacobian);
    QFETCH(PairJacobian, kept);
    const PairJacobian found = nearestNegativeSemidefinite(jacobian);
    QVERIFY(std::abs(found.xx - kept.xx) < 1e-15);
    QVERIFY(std::abs(found.xy - kept.xy) < 1e-15);
    QVERIFY(std::abs(found.yx - kept.yx) < 1e-15);
    QVERIFY(std::abs(found.yy - kept.yy) < 1e-15);
}

/// Against Eigen's eigenvalues.
void TestSafeguards::anySlopeLosesItsPushAndNothingElse()
{
    support::Dice dice(17);
    for (int i = 0; i < 1000; ++i) {
        const double turn = dice.chance(0.3) ? 0.0 : dice.real(-2, 2), side = dice.real(-1, 1);
        const PairJacobian jacobian = {dice.real(-1, 1), side + turn, side - turn, dice.real(-1, 1)};
        const PairJacobian found = nearestNegativeSemidefinite(jacobian);
        Eigen::Matrix2d symmetric;
        symmetric << jacobian.xx, side, side, jacobian.yy;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(symmetric);
        const Eigen::Matrix2d kept = eigen.eigenvectors() * eigen.eigenvalues().cwiseMin(0.0).asDiagonal() *
                                     eigen.eigenvectors().transpose();
        QVERIFY(std::abs(found.xx - kept(0, 0)) < 1e-14);
        QVERIFY(std::abs(found.yy - kept(1, 1)) < 1e-14);
        QVERIFY(std::abs(found.xy - (kept(0, 1) + turn)) < 1e-14);
        QVERIFY(std::abs(found.yx - (kept(1, 0) - turn)) < 1e-14);
    }
}

void TestSafeguards::aSolutionThatIsNotFoundIsNotLookedForForEver()
{
    // Each correction by Newton's method may be halved six times.
    const std::int64_t most = 1 + 20 * 7 + 1 + 60;
    for (const double k : {0.1, 1e4, 1e9})
        QVERIFY(burstApart(k, 7, 0.001, {}).evaluations <= most);
    QVERIFY(burstApart(1e4, 12, 0.0, {1000, 0}).evaluations > 1000); // without the bound
}

void TestSafeguards::whereEveryWayLeadsOutOfTheNumbersStandingStillIsNoAnswer_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("speed");
    QTest::addColumn<bool>("isLost");
    QTest::newRow("a pull without an end") << 1e308 << 0.0 << true;
    QTest::newRow("a throw without an end") << 1e6 << 1e307 << true;
    QTest::newRow("stiff, and thrown far") << 1e6 << 1e9 << false;
}

void TestSafeguards::whereEveryWayLeadsOutOfTheNumbersStandingStillIsNoAnswer()
{
    QFETCH(double, k);
    QFETCH(double, speed);
    QFETCH(bool, isLost);
    Scene scene =
        hard::creature(hard::valuesOf({{"k", k}, {"damp", 0.9}, {"radius", 50}, {"feet", 1}, {"out", 100}}));
    scene.start.setVelocity(scene.find("foot0"), {speed, 0.0});
    findMethod("backward_euler")->prepareState(scene.start);
    const Equations equations(scene, DirectionRule::regularised);
    State state = scene.start;
    ImplicitStep step(equations, state);
    const Numbers u = step.solve(step.motion.x, step.motion.v, 1.0);
    QCOMPARE(!u.isFinite().all(), isLost);
}

QTEST_GUILESS_MAIN(TestSafeguards)
#include "tst_safeguards.moc"
