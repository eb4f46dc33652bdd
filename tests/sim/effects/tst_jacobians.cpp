// The Jacobians of forces and torques against finite differences.

#include "sim/pipeline/pipeline.h"
#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "sim/effects/drivers/motor.h"
#include "sim/effects/fields/breeze.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/springs/springs.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/wind_torque.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

constexpr int jacobianFeet = 3;    // with the body: four points
constexpr double pushReach = 60.0; // px, distance below which points push each other

using ForcePtr = std::shared_ptr<const Force>;
using TorquePtr = std::shared_ptr<const Torque>;

/// Returns random points, some of them fixed, with different masses.
State randomPlaces(Dice &dice)
{
    State state = State::ofPoints(jacobianFeet + 1);
    state.gait.setConstant(1, dice.real(0, 6));
    state.gaitSpeed.setZero(1);
    state.input.target = {dice.real(-100, 100), dice.real(-100, 100)};
    for (int i = 0; i <= jacobianFeet; ++i) {
        state.place(i, {dice.real(-60, 60), dice.real(-60, 60)});
        state.inverseMass[i] = dice.chance(0.2) ? 0.0 : dice.chance(0.5) ? 1.0 : dice.real(0.1, 3.0);
    }
    return state;
}

/// Returns whether finite differences are accurate at `state`: no points are so close that forces turn fast,
/// and none is near the reach of a push.
bool isSmooth(const State &state)
{
    for (int i = 0; i < state.pointCount(); ++i) {
        for (int j = 0; j < i; ++j) {
            const double far = length(state.positionOf(i) - state.positionOf(j));
            if (far < 5.0 || std::abs(far - pushReach) < 0.1)
                return false;
        }
    }
    return true;
}

Eigen::MatrixXd matrixOf(const Jacobian &jacobian, int size)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (const Jacobian::Entry &entry : jacobian.entries())
        matrix(entry.row, entry.column) += entry.value;
    return matrix;
}

/// Returns the derivative of `function(s)` at s = 0, to fourth order.
template <class Function>
Eigen::VectorXd difference(double delta, Function &&function)
{
    const Eigen::VectorXd near = function(delta) - function(-delta);
    const Eigen::VectorXd far = function(2 * delta) - function(-2 * delta);
    return (8.0 * near - far) / (12.0 * delta);
}

Eigen::MatrixXd differences(const Force &force, const State &state, PointRange movers, double scale,
                            DirectionRule directionRule)
{
    const int size = 2 * state.pointCount();
    Eigen::MatrixXd matrix(size, size);
    for (int column = 0; column < size; ++column) {
        matrix.col(column) = difference(1e-2, [&](double by) -> Eigen::VectorXd {
            State moved = state;
            moved.position.data()[column] += by;
            Eigen::ArrayX2d acceleration = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
            force.add(moved, movers, scale, directionRule, acceleration);
            return acceleration.reshaped().matrix();
        });
    }
    return matrix;
}

/// Returns a tree with two levels of branches at uneven angles.
Tree oddTree()
{
    Tree tree = Tree::ofTrunk(100.0);
    tree.addBranch(0, -120.0, 0.7);
    tree.addBranch(0, -55.0, 0.8);
    tree.addBranch(1, -150.0, 0.5);
    tree.addBranch(2, -80.0, 0.6);
    tree.addBranch(2, -20.0, 0.55);
    return tree;
}

State bentTree(const Tree &tree, Dice &dice)
{
    State state = State::ofPoints(tree.branchCount());
    state.place(0, {270, 380});
    state.spin.setZero(tree.branchCount());
    state.angle.resize(tree.branchCount());
    for (int i = 0; i < tree.branchCount(); ++i) {
        state.angle[i] = tree.rest[std::size_t(i)] + dice.real(-40, 40);
        state.place(i, {dice.real(100, 400), dice.real(100, 400)}); // held branches stay there
        state.inverseMass[i] = dice.chance(0.2) ? 0.0 : 1.0;
    }
    state.input.pointer = Vec2{dice.real(100, 500), dice.real(0, 100)};
    state.gustExtent = {1e4, 1.0};
    return state;
}

/// A force without a Jacobian.
class ForceWithoutJacobian : public Force
{
public:
    std::string id() const override { return "steady"; }
    std::string title() const override { return "steady"; }
    EffectKind kind() const override { return EffectKind::wind; }
    std::vector<Region> regions(DirectionRule) const override { return {{"file", "marker"}}; }
    int count(const State &, PointRange points) const override { return points.count; }
    void add(const State &, PointRange movers, double scale, DirectionRule,
             Eigen::ArrayX2d &acceleration) const override
    {
        acceleration.middleRows(movers.first, movers.count) += scale;
    }
    std::vector<LiveValue> explain(const State &, int, DirectionRule) const override { return {}; }
};

}

class TestJacobians : public QObject
{
    Q_OBJECT

private:
    static constexpr double k = 0.23;

    static void addForceRows()
    {
        QTest::addColumn<ForcePtr>("force");
        QTest::addColumn<DirectionRule>("directionRule");
        const std::vector<Leg> legs = {{0, jacobianFeet, 0.3, 0}, {1, jacobianFeet, 2.5, 0}, {2, 1, 4.0, 0}};
        const auto legSpring = [&](Aim aim, Reaction reaction) {
            return std::make_shared<LegSpring>(legs, LegRule{k, 50.0, 30.0, aim, reaction});
        };
        const std::vector<std::pair<const char *, ForcePtr>> forces = {
            {"spring to a point", std::make_shared<PointSpring>(1, Vec2{27, 20}, k)},
            {"spring to a body", std::make_shared<BodySpring>(std::vector<Link>{{0, jacobianFeet}}, k)},
            {"springs to every foot", std::make_shared<BodySpring>(scenes::legs(jacobianFeet), k)},
            {"springs with an offset", std::make_shared<OffsetSpring>(scenes::legs(jacobianFeet), k, 50)},
            {"radial springs", std::make_shared<RadialSpring>(scenes::legs(jacobianFeet), k, 50)},
            {"radial spring of length 0", std::make_shared<RadialSpring>(scenes::legs(1), k, 0)},
            {"gravity", std::make_shared<Gravity>(0.5)},
            {"legs", legSpring(Aim::bone, Reaction::none)},
            {"swinging legs that the body feels", legSpring(Aim::swing, Reaction::equal)},
            {"push", std::make_shared<Push>(std::vector<int>{0, 1, 2, 3}, k, pushReach, Reaction::none)},
            {"push and reaction",
             std::make_shared<Push>(std::vector<int>{0, 1, 3}, k, pushReach, Reaction::equal)},
            {"motor", std::make_shared<Motor>(2, k, 0.25)},
            {"springs with individual stiffness",
             std::make_shared<Springs>(std::vector<Spring>{{0, jacobianFeet, k, 50}, {1, 2, 0.4 * k, 20}},
                                       jacobianFeet + 1)},
            {"wind", std::make_shared<Breeze>(BreezeStrength{0.4, 0.7},
                                              Eigen::ArrayXd::LinSpaced(jacobianFeet + 1, 5, 30), 0)},
        };
        for (const auto &[name, force] : forces) {
            QTest::addRow("%s, regularised", name) << force << DirectionRule::regularised;
            QTest::addRow("%s, as published", name) << force << DirectionRule::published;
        }
    }

private slots:
    void forceJacobianMatchesDifferences_data() { addForceRows(); }
    void forceJacobianMatchesDifferences()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        Dice dice(5);
        int compared = 0;
        while (compared < 300) {
            const State state = randomPlaces(dice);
            if (!isSmooth(state))
                continue;
            ++compared;
            const int first = dice.whole(0, 1);
            const PointRange movers = {first, state.pointCount() - 2 * first};
            Jacobian jacobian(state.pointCount());
            QVERIFY(force->addJacobian(state, movers, 0.7, directionRule, jacobian));
            const Eigen::MatrixXd returned = matrixOf(jacobian, 2 * state.pointCount());
            const Eigen::MatrixXd differenced = differences(*force, state, movers, 0.7, directionRule);
            // Rounding gives 100 px k 1e-16 / 1e-2 px. Truncation is larger, as the fifth derivative is 1e-1
            // at 5 px.
            QVERIFY2((returned - differenced).cwiseAbs().maxCoeff() < 1e-7,
                     qPrintable(QString::number((returned - differenced).cwiseAbs().maxCoeff())));
        }
    }

    void jacobianIsFiniteForCoincidentPoints_data() { addForceRows(); }
    void jacobianIsFiniteForCoincidentPoints()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        State state = State::ofPoints(jacobianFeet + 1);
        state.gait.setZero(1);
        Jacobian jacobian(state.pointCount());
        QVERIFY(force->addJacobian(state, {0, state.pointCount()}, 1.0, directionRule, jacobian));
        for (const Jacobian::Entry &entry : jacobian.entries())
            QVERIFY(std::abs(entry.value) <= 2 * k); // bounded by the stiffness of the spring
    }

    void fixedPointsHaveNoJacobian_data() { addForceRows(); }
    void fixedPointsHaveNoJacobian()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        Dice dice(8);
        State state = randomPlaces(dice);
        state.inverseMass.setZero();
        Jacobian jacobian(state.pointCount());
        QVERIFY(force->addJacobian(state, {0, state.pointCount()}, 1.0, directionRule, jacobian));
        QVERIFY(jacobian.entries().empty());
    }

    void torqueJacobianMatchesDifferences_data()
    {
        QTest::addColumn<TorquePtr>("torque");
        const auto tree = std::make_shared<const Tree>(oddTree());
        const BranchMechanics mechanics = branchMechanicsOf(*tree, k);
        QTest::newRow("joints that spring back") << TorquePtr(std::make_shared<Torsion>(tree, mechanics));
        QTest::newRow("steady wind") << TorquePtr(
            std::make_shared<WindTorque>(tree, mechanics.inertia, 8.0, 0.0));
        QTest::newRow("gusts") << TorquePtr(std::make_shared<WindTorque>(tree, mechanics.inertia, 8.0, 0.5));
    }
    void torqueJacobianMatchesDifferences()
    {
        QFETCH(TorquePtr, torque);
        const auto tree = std::make_shared<const Tree>(oddTree());
        const Joints joints(tree, degreesPerRadian);
        Dice dice(9);
        int compared = 0;
        double largest = 0.0;
        while (compared < 200) {
            State state = bentTree(*tree, dice);
            joints.drive(state, 0.0);
            bool isSmoothHere = true;
            for (int i = 0; i < state.pointCount(); ++i) {
                const Vec2 end = endOf(*tree, state, i, degreesPerRadian);
                const double far = length(end - *state.input.pointer);
                // the strength of the wind is constant below 100 px, and its direction turns fast close to
                // the pointer
                isSmoothHere = isSmoothHere && far > 10.0 && std::abs(far - 100.0) > 0.5;
            }
            if (!isSmoothHere)
                continue;
            ++compared;
            const int points = state.pointCount();
            Jacobian jacobian(points);
            QVERIFY(torque->addJacobian(state, {0, points}, 0.7, jacobian));
            const Eigen::MatrixXd returned = matrixOf(jacobian, 3 * points);
            QVERIFY(returned.topRows(2 * points).isZero(0.0) && returned.leftCols(2 * points).isZero(0.0));
            for (int branch = 0; branch < points; ++branch) {
                const Eigen::VectorXd differenced = difference(1e-2, [&](double by) -> Eigen::VectorXd {
                    State turned = state;
                    turned.angle[branch] += by;
                    joints.drive(turned, 0.0);
                    Eigen::ArrayXd acceleration = Eigen::ArrayXd::Zero(points);
                    torque->add(turned, {0, points}, 0.7, acceleration);
                    return acceleration.matrix();
                });
                const Eigen::VectorXd error = returned.col(2 * points + branch).tail(points) - differenced;
                QVERIFY2(error.cwiseAbs().maxCoeff() < 1e-8, qPrintable(QString::number(error.norm())));
                largest = std::max(largest, differenced.cwiseAbs().maxCoeff());
            }
        }
        QVERIFY(largest > 1e-3); // the torque does change
    }

    void calmWindHasNoJacobian()
    {
        const auto tree = std::make_shared<const Tree>(oddTree());
        const WindTorque wind(tree, branchMechanicsOf(*tree, k).inertia, 8.0, 0.5);
        Dice dice(10);
        State state = bentTree(*tree, dice);
        state.gustExtent = {};
        Jacobian jacobian(state.pointCount());
        QVERIFY(wind.addJacobian(state, {0, state.pointCount()}, 1.0, jacobian));
        QVERIFY(jacobian.entries().empty());
    }

    void implicitMethodsRefuseAForceWithoutJacobian()
    {
        Scene scene = scenes::creature(jacobianFeet);
        scene.effects = {std::make_shared<Gravity>(0.5), std::make_shared<ForceWithoutJacobian>()};
        int refused = 0;
        for (const MethodPtr &method : allMethods()) {
            const std::vector<std::string> needs = method->requirements();
            if (std::find(needs.begin(), needs.end(), "jacobian") == needs.end())
                continue;
            try {
                compose(scene, *method, StepSize::ofLength(1.0));
                QFAIL(method->id().c_str());
            } catch (const Error &error) {
                QCOMPARE(error.id(), std::string("method-does-not-fit"));
                QCOMPARE(error.values().at("effect"), std::string("steady"));
                QCOMPARE(error.values().at("method"), method->id());
                ++refused;
            }
        }
        QVERIFY(refused >= 3);
    }
};

SUITE(tst_jacobians, TestJacobians)
#include "tst_jacobians.moc"
