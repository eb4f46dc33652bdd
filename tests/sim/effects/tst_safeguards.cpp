// Safeguards against non-finite runs, each compared with what would happen without it.

#include "sim/pipeline/pipeline.h"
#include "sim/run/finite.h"
#include "tests/sim/support/support.h"

#include "sim/base/direction.h"
#include "sim/base/error.h"
#include "sim/catalogue/scenes.h"
#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/methods/implicit/newton.h"
#include "sim/methods/implicit/solvers/semidefinite.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <Eigen/Eigenvalues>

#include <QTest>

#include <cmath>
#include <limits>

using namespace sim;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusalOf(const Script &script)
{
    try {
        Track(script, 0);
    } catch (const Error &error) {
        return error.id();
    }
    return {};
}

/// The result of a step of backward Euler.
struct StepResult
{
    double residual = 0.0;        ///< px/frame, largest error of the step's equation
    std::int64_t evaluations = 0; ///< force evaluations
};

/// Computes a first step of one frame for `feet` feet at `out` px from their body, on springs of 50 px.
StepResult firstImplicitStep(double k, int feet, double out, CorrectionLimits jacobianKind)
{
    Scene scene = hard::creature(
        hard::valuesOf({{"k", k}, {"damp", 0.9}, {"radius", 50}, {"feet", double(feet)}, {"out", out}}));
    findMethod("backward_euler")->prepareState(scene.start);
    const Equations equations(scene, DirectionRule::regularised);
    State state = scene.start;
    ImplicitStep step(equations, state, jacobianKind);
    const Numbers from = step.motion.x, drift = step.motion.v, share = step.kept(1.0);
    const Numbers u = step.solve(from, drift, 1.0, share);
    const auto evaluations = static_cast<std::int64_t>(state.forceEvaluations());
    const Numbers residual = u - drift - share * step.accelerations(from + u);
    return {residual.abs().maxCoeff(), evaluations};
}

/// Returns the Jacobian of a spring that is compressed to half its length.
Jacobian compressedSpring()
{
    Jacobian jacobian(2);
    const Vec2 from = {15.0, 20.0};
    addPairJacobian(jacobian, 0, 1, radialSpringJacobian(from, 1.0, 50.0));
    addPairJacobian(jacobian, 1, 0, radialSpringJacobian(-1.0 * from, 1.0, 50.0));
    return jacobian;
}

/// Returns the smallest eigenvalue of the identity minus the matrix of `entries`.
double smallestEigenvalue(const std::vector<Jacobian::Entry> &entries)
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
    void nonFiniteInputIsRefused_data();
    void nonFiniteInputIsRefused();
    void refusedInputLeavesTheRunUnchanged();
    void nonFinitePositionWouldSpreadToCoupledPoints();
    void nonFiniteStartIsRefused_data();
    void nonFiniteStartIsRefused();
    void coincidentPointsHaveADirection();
    void windAtDistanceZeroTurnsNoFartherThanItsDirection();
    void spineOfLengthZeroHasAFiniteWidth();
    void coincidentCreatureIsSolved_data();
    void coincidentCreatureIsSolved();
    void moreNewtonIterationsDoNotHelp();
    void projectionRemovesPositiveEigenvalues();
    void projectionKeepsNegativeSemidefiniteBlocks();
    void projectionKeepsTheAntisymmetricPart_data();
    void projectionKeepsTheAntisymmetricPart();
    void projectionAgreesWithEigenvalues();
    void solverStopsWithoutASolution();
    void overflowingStepIsNotReportedAsStandingStill_data();
    void overflowingStepIsNotReportedAsStandingStill();
};

void TestSafeguards::nonFiniteInputIsRefused_data()
{
    QTest::addColumn<double>("number");
    QTest::newRow("not a number") << notANumber;
    QTest::newRow("infinity") << infinity;
    QTest::newRow("negative infinity") << -infinity;
}

void TestSafeguards::nonFiniteInputIsRefused()
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

void TestSafeguards::refusedInputLeavesTheRunUnchanged()
{
    Timeline timeline(support::script(support::sample("spring to a point"), "published"));
    timeline.applyInput(Grab{"foot"});
    timeline.seek({5, 0});
    const State before = timeline.state();
    try {
        timeline.applyInput(Move{{notANumber, 200.0}});
        QFAIL("the input was accepted");
    } catch (const Error &error) {
        QCOMPARE(error.values().at("event"), std::string("move"));
        QCOMPARE(error.values().at("frame"), std::string("6"));
    }
    QCOMPARE(timeline.script().input.size(), std::size_t(1));
    QVERIFY(sameBits(timeline.state(), before));
    QVERIFY(!timeline.comparison());
}

void TestSafeguards::nonFinitePositionWouldSpreadToCoupledPoints()
{
    const Scene scene = support::sample("heavy pair").build(support::sample("heavy pair").values);
    State state = scene.start;
    const MethodPtr method = findMethod("semi_implicit_euler");
    method->prepareState(state);
    const Pipeline pipeline = compose(scene, *method, StepSize::ofLength(1.0));
    state.place(0, {notANumber, 200.0}); // as the refused move would
    for (const Phase &phase : pipeline.phases)
        phase.run(state);
    QCOMPARE(firstNonFinitePoint(state), 0);
    QVERIFY(!std::isfinite(state.positionOf(1).x)); // the point on the same spring
}

void TestSafeguards::nonFiniteStartIsRefused_data()
{
    nonFiniteInputIsRefused_data();
}

void TestSafeguards::nonFiniteStartIsRefused()
{
    QFETCH(double, number);
    const auto refusal = [](const BodyStart &start) {
        Script script = support::script(support::sample("heavy pair"), "semi_implicit_euler");
        const std::string name = script.build(script.values).names.at(1);
        script.bodies[name] = start;
        try {
            Track(script, 0);
        } catch (const Error &error) {
            return error.id() + (error.values().at("body") == name ? ", with the name" : "");
        }
        return std::string();
    };
    QCOMPARE(refusal({{number, 200.0}, {}}), std::string("start-not-finite, with the name"));
    QCOMPARE(refusal({{270.0, number}, {}}), std::string("start-not-finite, with the name"));
    QCOMPARE(refusal({{270.0, 200.0}, Vec2{number, 0.0}}), std::string("start-not-finite, with the name"));
    QCOMPARE(refusal({{270.0, 200.0}, Vec2{1.0, 0.0}}), std::string());
}

void TestSafeguards::coincidentPointsHaveADirection()
{
    const Vec2 d = {0.0, 0.0};
    QVERIFY(std::isnan(d.x / length(d))); // without the fallback direction
    const Vec2 out = direction(d, 3, 4).out, back = direction(d, 4, 3).out;
    QVERIFY(std::abs(length(out) - 1.0) < 1e-15);
    QCOMPARE(out.x, -back.x);
    QCOMPARE(out.y, -back.y);
}

void TestSafeguards::windAtDistanceZeroTurnsNoFartherThanItsDirection()
{
    const double drag = byDistance(0.0);
    QVERIFY(!std::isfinite(bendPublished(0.0, 90.0, drag, 1.0))); // without the bound on the angle
    QCOMPARE(bend(0.0, 90.0, drag, 1.0), 90.0);
}

void TestSafeguards::spineOfLengthZeroHasAFiniteWidth()
{
    const Direction none = {0.0, {1.0, 0.0}};
    const Vec2 left = {0.0, -5.0}, right = {0.0, 5.0};
    QVERIFY(!std::isfinite(keepArea(left, right, none, 400.0, 0.0, 0.5).wanted)); // without a shortest spine
    QCOMPARE(keepArea(left, right, none, 400.0, 10.0, 0.5).wanted, 80.0);
}

void TestSafeguards::coincidentCreatureIsSolved_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<int>("feet");
    QTest::addColumn<double>("out");
    QTest::newRow("soft, coincident") << 0.1 << 15 << 0.0;
    QTest::newRow("coincident") << 1.0 << 20 << 0.0;
    QTest::newRow("stiff, coincident") << 1e4 << 12 << 0.0;
    QTest::newRow("stiff, nearly coincident") << 1e4 << 40 << 0.001;
    QTest::newRow("stiff, within one px") << 1e6 << 12 << 1.0;
}

void TestSafeguards::coincidentCreatureIsSolved()
{
    QFETCH(double, k);
    QFETCH(int, feet);
    QFETCH(double, out);
    const StepResult without = firstImplicitStep(k, feet, out, {20, 0});
    const StepResult with = firstImplicitStep(k, feet, out, {});
    QVERIFY2(without.residual > 0.1, qPrintable(QString::number(without.residual)));
    // Relative to the rounding error of forces of k times 50 px.
    QVERIFY2(with.residual < 1e-8 + 1e-14 * k * 50.0 * feet, qPrintable(QString::number(with.residual)));
}

void TestSafeguards::moreNewtonIterationsDoNotHelp()
{
    QVERIFY(firstImplicitStep(1e4, 12, 0.0, {1000, 0}).residual > 0.1);
}

void TestSafeguards::projectionRemovesPositiveEigenvalues()
{
    // Across a spring of half its length the derivative is k (50 / 25 - 1) for each end, which gives an
    // eigenvalue of 1 - 2.
    const Jacobian jacobian = compressedSpring();
    QVERIFY(std::abs(smallestEigenvalue(jacobian.entries()) - (1.0 - 2.0)) < 1e-12);
    QVERIFY(std::abs(smallestEigenvalue(nearestNegativeSemidefiniteBlocks(jacobian, 2)) - 1.0) < 1e-12);
}

void TestSafeguards::projectionKeepsNegativeSemidefiniteBlocks()
{
    Jacobian jacobian(2);
    addPairJacobian(jacobian, 0, 1, radialSpringJacobian({60.0, 80.0}, 1.0, 50.0));
    jacobian.addAngular(0, 1, 3.0);
    const std::vector<Jacobian::Entry> projected = nearestNegativeSemidefiniteBlocks(jacobian, 2);
    QCOMPARE(projected.size(), jacobian.entries().size());
    for (std::size_t i = 0; i < projected.size(); ++i)
        QCOMPARE(projected[i].value, jacobian.entries()[i].value);
}

void TestSafeguards::projectionKeepsTheAntisymmetricPart_data()
{
    QTest::addColumn<PairJacobian>("jacobian");
    QTest::addColumn<PairJacobian>("expected");
    QTest::newRow("only antisymmetric") << PairJacobian{0, 3, -3, 0} << PairJacobian{0, 3, -3, 0};
    QTest::newRow("negative and antisymmetric") << PairJacobian{-2, 3, -3, -1} << PairJacobian{-2, 3, -3, -1};
    QTest::newRow("positive along y and antisymmetric")
        << PairJacobian{-2, 3, -3, 1} << PairJacobian{-2, 3, -3, 0};
    QTest::newRow("positive along x and antisymmetric")
        << PairJacobian{4, 3, -3, -1} << PairJacobian{0, 3, -3, -1};
    QTest::newRow("positive and antisymmetric") << PairJacobian{1, 3, -3, 2} << PairJacobian{0, 3, -3, 0};
    // The symmetric part is (-1, 2; 2, -1): 1 along (1, 1), and -3 across.
    QTest::newRow("positive along a diagonal and antisymmetric")
        << PairJacobian{-1, 2.5, 1.5, -1} << PairJacobian{-1.5, 2, 1, -1.5};
}

void TestSafeguards::projectionKeepsTheAntisymmetricPart()
{
    QFETCH(PairJacobian, jacobian);
    QFETCH(PairJacobian, expected);
    const PairJacobian found = nearestNegativeSemidefinite(jacobian);
    QVERIFY(std::abs(found.xx - expected.xx) < 1e-15);
    QVERIFY(std::abs(found.xy - expected.xy) < 1e-15);
    QVERIFY(std::abs(found.yx - expected.yx) < 1e-15);
    QVERIFY(std::abs(found.yy - expected.yy) < 1e-15);
}

void TestSafeguards::projectionAgreesWithEigenvalues()
{
    support::Dice dice(17);
    for (int i = 0; i < 1000; ++i) {
        const double antisymmetric = dice.chance(0.3) ? 0.0 : dice.real(-2, 2),
                     offDiagonal = dice.real(-1, 1);
        const PairJacobian jacobian = {dice.real(-1, 1), offDiagonal + antisymmetric,
                                       offDiagonal - antisymmetric, dice.real(-1, 1)};
        const PairJacobian found = nearestNegativeSemidefinite(jacobian);
        Eigen::Matrix2d symmetric;
        symmetric << jacobian.xx, offDiagonal, offDiagonal, jacobian.yy;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(symmetric);
        const Eigen::Matrix2d expected = eigen.eigenvectors() *
                                         eigen.eigenvalues().cwiseMin(0.0).asDiagonal() *
                                         eigen.eigenvectors().transpose();
        QVERIFY(std::abs(found.xx - expected(0, 0)) < 1e-14);
        QVERIFY(std::abs(found.yy - expected(1, 1)) < 1e-14);
        QVERIFY(std::abs(found.xy - (expected(0, 1) + antisymmetric)) < 1e-14);
        QVERIFY(std::abs(found.yx - (expected(1, 0) - antisymmetric)) < 1e-14);
    }
}

void TestSafeguards::solverStopsWithoutASolution()
{
    // Each Newton correction may be halved six times.
    const std::int64_t maxEvaluations = 1 + 20 * 7 + 1 + 60;
    for (const double k : {0.1, 1e4, 1e9})
        QVERIFY(firstImplicitStep(k, 7, 0.001, {}).evaluations <= maxEvaluations);
    QVERIFY(firstImplicitStep(1e4, 12, 0.0, {1000, 0}).evaluations > 1000); // with a larger limit
}

void TestSafeguards::overflowingStepIsNotReportedAsStandingStill_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("speed");
    QTest::addColumn<bool>("isLost");
    QTest::newRow("an overflowing force") << 1e308 << 0.0 << true;
    QTest::newRow("an overflowing throw") << 1e6 << 1e307 << true;
    QTest::newRow("stiff, and thrown far") << 1e6 << 1e9 << false;
}

void TestSafeguards::overflowingStepIsNotReportedAsStandingStill()
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

SUITE(tst_safeguards, TestSafeguards)
#include "tst_safeguards.moc"
