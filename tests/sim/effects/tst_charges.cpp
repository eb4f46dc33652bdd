// Charges: force law, Jacobian and potential energy against closed forms and differences.

#include "sim/pipeline/pipeline.h"
#include "tests/sim/support/support.h"

#include "sim/effects/all_effects.h"
#include "sim/effects/fields/charges.h"
#include "sim/methods/methods.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "tests/suite.h"

#include <QTest>

#include <cstring>
#include <numbers>

using namespace sim;
using support::Dice;

namespace {

constexpr double strength = 1000.0, defaultSoftening = 10.0;

Eigen::ArrayXd chargesOf(std::initializer_list<double> charges)
{
    Eigen::ArrayXd all(static_cast<Eigen::Index>(charges.size()));
    std::copy(charges.begin(), charges.end(), all.begin());
    return all;
}

/// Returns a scene of points with charges and no other effect.
Scene sceneOf(const std::vector<Vec2> &places, const Eigen::ArrayXd &charge,
              double softening = defaultSoftening)
{
    Scene scene = scenes::pointsAt(places);
    scenes::add<Charges>(scene, charge, strength, softening);
    return scene;
}

const Charges &chargesIn(const Scene &scene)
{
    return dynamic_cast<const Charges &>(*scene.effects.front());
}

Eigen::ArrayX2d accelerationsIn(const Scene &scene, DirectionRule directionRule = DirectionRule::regularised)
{
    Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(scene.start.pointCount(), 2);
    chargesIn(scene).add(scene.start, {0, scene.start.pointCount()}, 1.0, directionRule, sum);
    return sum;
}

/// Returns the sum of potential and kinetic energy.
double energyOf(const Scene &scene, const State &state)
{
    const Eigen::ArrayXd square = state.velocity.square().rowwise().sum();
    return chargesIn(scene).potentialEnergy(state).value() + 0.5 * (square / state.inverseMass).sum();
}

State after(const Scene &scene, const char *method, StepSize step, int frames)
{
    Script script = support::script(scene, method);
    script.step = step;
    Timeline run(script);
    run.seek({frames, 0});
    return run.state();
}

/// Returns random points with charges of both signs, different masses, fixed points and two coincident
/// points.
Scene anyScene(int points, std::uint64_t seed)
{
    Dice dice(seed);
    std::vector<Vec2> places;
    Eigen::ArrayXd charge(points);
    for (int i = 0; i < points; ++i) {
        places.push_back({dice.real(0, 500), dice.real(0, 400)});
        charge[i] = dice.chance(0.2) ? 0.0 : dice.real(-3, 3);
    }
    if (points > 3)
        places[3] = places[1];
    Scene scene = sceneOf(places, charge);
    for (int i = 0; i < points; ++i)
        scene.start.inverseMass[i] = dice.chance(0.1) ? 0.0 : dice.chance(0.3) ? dice.real(0.1, 3.0) : 1.0;
    return scene;
}

}

class TestCharges : public QObject
{
    Q_OBJECT

private slots:
    void forceFollowsTheSoftenedInverseSquareLaw_data()
    {
        QTest::addColumn<double>("q1");
        QTest::addColumn<double>("q2");
        QTest::addColumn<double>("distance");
        QTest::newRow("like charges repel") << 1.0 << 2.0 << 50.0;
        QTest::newRow("negative charges repel, too") << -1.5 << -2.0 << 50.0;
        QTest::newRow("unlike charges attract") << 3.0 << -0.5 << 120.0;
        QTest::newRow("closer than the softening") << 1.0 << 1.0 << 0.001;
        QTest::newRow("very far away") << 1.0 << 1.0 << 1e200;
    }
    void forceFollowsTheSoftenedInverseSquareLaw()
    {
        QFETCH(double, q1);
        QFETCH(double, q2);
        QFETCH(double, distance);
        const double mass = 2.0;
        Scene scene = sceneOf({{0.6 * distance, 0.8 * distance}, {}}, chargesOf({q1, q2}));
        scene.start.inverseMass[0] = 1.0 / mass;
        const double force = strength * q1 * q2 / (distance * distance + defaultSoftening * defaultSoftening);
        for (const DirectionRule directionRule : {DirectionRule::regularised, DirectionRule::published}) {
            const Eigen::ArrayX2d accelerations = accelerationsIn(scene, directionRule);
            QVERIFY(std::abs(accelerations(0, 0) - 0.6 * force / mass) <= 1e-12 * std::abs(force));
            QVERIFY(std::abs(accelerations(0, 1) - 0.8 * force / mass) <= 1e-12 * std::abs(force));
            QVERIFY((accelerations.row(0) * mass == -accelerations.row(1)).all());
        }
    }

    void jacobianMatchesDifferences_data()
    {
        QTest::addColumn<double>("q");
        QTest::newRow("like charges") << 1.5;
        QTest::newRow("unlike charges") << -1.5;
    }
    void jacobianMatchesDifferences()
    {
        QFETCH(double, q);
        Dice dice(3);
        for (int run = 0; run < 200; ++run) {
            Scene scene = sceneOf({{dice.real(-60, 60), dice.real(-60, 60)},
                                   {dice.real(-60, 60), dice.real(-60, 60)},
                                   {dice.real(-60, 60), dice.real(-60, 60)}},
                                  chargesOf({q, 2.0, 0.5}));
            scene.start.inverseMass << 1.0, dice.real(0.1, 3.0), dice.chance(0.3) ? 0.0 : 1.0;
            double nearest = 1e9;
            for (int i = 0; i < 3; ++i)
                nearest = std::min(nearest,
                                   length(scene.start.positionOf(i) - scene.start.positionOf((i + 1) % 3)));
            if (nearest < 5.0)
                continue; // the force changes too fast for differences
            Jacobian jacobian(3);
            QVERIFY(
                chargesIn(scene).addJacobian(scene.start, {0, 3}, 1.0, DirectionRule::regularised, jacobian));
            Eigen::MatrixXd jacobianMatrix = Eigen::MatrixXd::Zero(6, 6);
            for (const Jacobian::Entry &entry : jacobian.entries())
                jacobianMatrix(entry.row, entry.column) += entry.value;
            for (int column = 0; column < 6; ++column) {
                const auto accelerationsAt = [&](double by) -> Eigen::VectorXd {
                    Scene moved = scene;
                    moved.start.position.data()[column] += by;
                    return accelerationsIn(moved).reshaped().matrix();
                };
                const double step = 1e-3;
                const Eigen::VectorXd differences =
                    (8.0 * (accelerationsAt(step) - accelerationsAt(-step)) -
                     (accelerationsAt(2.0 * step) - accelerationsAt(-2.0 * step))) /
                    (12.0 * step);
                QVERIFY((jacobianMatrix.col(column) - differences).cwiseAbs().maxCoeff() < 1e-8);
            }
        }
    }

    void jacobianIsFiniteForCoincidentPoints()
    {
        const Scene scene = sceneOf({{1, 2}, {1, 2}}, chargesOf({1, -1}));
        Jacobian jacobian(2);
        QVERIFY(chargesIn(scene).addJacobian(scene.start, {0, 2}, 1.0, DirectionRule::regularised, jacobian));
        for (const Jacobian::Entry &entry : jacobian.entries())
            QVERIFY(std::isfinite(entry.value));
    }

    void potentialEnergyIsTheWorkOfTheForce_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::newRow("from zero distance") << 0.0 << 30.0;
        QTest::newRow("near") << 5.0 << 40.0;
        QTest::newRow("far") << 200.0 << 900.0;
    }
    void potentialEnergyIsTheWorkOfTheForce()
    {
        QFETCH(double, from);
        QFETCH(double, to);
        const auto sceneAt = [](double x) { return sceneOf({{x, 0}, {}}, chargesOf({1.5, 2.0})); };
        const auto energyAt = [&](double x) {
            const Scene scene = sceneAt(x);
            return chargesIn(scene).potentialEnergy(scene.start).value();
        };
        const auto forceAt = [&](double x) { return accelerationsIn(sceneAt(std::max(x, 1e-9)))(0, 0); };
        const int intervals = 2000;
        const double step = (to - from) / intervals;
        double work = forceAt(from) + forceAt(to); // Simpson's rule
        for (int i = 1; i < intervals; ++i)
            work += (i % 2 == 1 ? 4.0 : 2.0) * forceAt(from + i * step);
        work *= step / 3.0;
        QVERIFY(std::abs(energyAt(from) - energyAt(to) - work) < 1e-7 * work);
    }

    void potentialEnergyVanishesAtADistance()
    {
        const Scene scene = sceneOf({{1e12, 0}, {}}, chargesOf({1, 1}));
        QVERIFY(std::abs(chargesIn(scene).potentialEnergy(scene.start).value() - strength / 1e12) < 1e-18);
    }

    void energyErrorOfVerletFallsWithTheSquareOfTheStep()
    {
        Scene scene = sceneOf({{200, 200}, {330, 200}, {260, 300}}, chargesOf({2, -1, 1.5}));
        scene.start.inverseMass << 1.0, 0.5, 2.0;
        scene.start.setVelocity(0, {0.5, -0.3});
        const double start = energyOf(scene, scene.start);
        const auto maxError = [&](double h) {
            double error = 0.0;
            for (int frames = 20; frames <= 200; frames += 20)
                error = std::max(error, std::abs(energyOf(scene, after(scene, "velocity_verlet",
                                                                       StepSize::ofLength(h), frames)) -
                                                 start));
            return error;
        };
        const double coarse = maxError(0.125), fine = maxError(0.0625);
        QVERIFY2(coarse < 1e-2 * std::abs(start), qPrintable(QString::number(coarse)));
        QVERIFY2(coarse / fine > 3.5 && coarse / fine < 4.5, qPrintable(QString::number(coarse / fine)));
    }

    void twoChargesConserveMomentumExactly()
    {
        for (const double q : {1.0, -1.0}) {
            const Scene scene = sceneOf({{200, 200}, {300, 230}}, chargesOf({2, q}));
            const State end = after(scene, "semi_implicit_euler", StepSize::ofLength(1.0), 200);
            QVERIFY((end.velocity.row(0) != 0.0).any());
            QVERIFY((end.velocity.row(0) == -end.velocity.row(1)).all());
        }
    }

    /// On a circle the attraction is the centripetal force: w^2 d = K (1/m1 + 1/m2) / (d^2 + s^2).
    void unlikeChargesOrbitWithTheExactPeriod_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("softening");
        QTest::newRow("hardly softened: Kepler's third law") << 100.0 << 1.0;
        QTest::newRow("softened") << 100.0 << 40.0;
        QTest::newRow("within the softening") << 30.0 << 60.0;
    }
    void unlikeChargesOrbitWithTheExactPeriod()
    {
        QFETCH(double, distance);
        QFETCH(double, softening);
        const double m1 = 1.0, m2 = 3.0, period = 200.0;
        const double angularVelocity = 2.0 * std::numbers::pi / period;
        const double attraction = angularVelocity * angularVelocity * distance *
                                  (distance * distance + softening * softening) / (1.0 / m1 + 1.0 / m2);
        const double x1 = distance * m2 / (m1 + m2), x2 = distance * m1 / (m1 + m2);
        Scene scene = sceneOf({{x1, 0}, {-x2, 0}}, chargesOf({attraction / strength, -1.0}), softening);
        scene.start.inverseMass << 1.0 / m1, 1.0 / m2;
        scene.start.setVelocity(0, {0, angularVelocity * x1});
        scene.start.setVelocity(1, {0, -angularVelocity * x2});
        const State half = after(scene, "dop853", StepSize::withTolerance(1e-10), 100);
        QVERIFY(length(half.positionOf(0) - Vec2{-x1, 0}) < 1e-6);
        const State full = after(scene, "dop853", StepSize::withTolerance(1e-10), 200);
        QVERIFY(length(full.positionOf(0) - Vec2{x1, 0}) < 1e-6);
        QVERIFY(length(full.positionOf(1) - Vec2{-x2, 0}) < 1e-6);
    }

    void fewerThanTwoChargesMakeNoPhase_data()
    {
        QTest::addColumn<QList<double>>("charges");
        QTest::addColumn<double>("given");
        QTest::addColumn<bool>("acts");
        QTest::newRow("no charge") << QList<double>{0, 0, 0} << strength << false;
        QTest::newRow("one charge") << QList<double>{0, 2, 0} << strength << false;
        QTest::newRow("no strength") << QList<double>{1, 2, 3} << 0.0 << false;
        QTest::newRow("two charges") << QList<double>{1, 0, -1} << strength << true;
    }
    void fewerThanTwoChargesMakeNoPhase()
    {
        QFETCH(QList<double>, charges);
        QFETCH(double, given);
        QFETCH(bool, acts);
        Scene scene = sceneOf({{0, 0}, {50, 0}, {0, 80}}, chargesOf({0, 0, 0}));
        scene.effects = {std::make_shared<Charges>(Eigen::Map<const Eigen::ArrayXd>(charges.data(), 3), given,
                                                   defaultSoftening)};
        const Pipeline pipeline = compose(scene, *findMethod("semi_implicit_euler"), StepSize::ofLength(1.0));
        const auto isOfCharges = [&](const Phase &phase) { return phase.effect == scene.effects.front(); };
        QCOMPARE(std::any_of(pipeline.phases.begin(), pipeline.phases.end(), isOfCharges), acts);
        QCOMPARE(pipeline.idleEffects.empty(), acts);
    }

    void pointWithoutChargeFeelsNothing()
    {
        const Scene scene = sceneOf({{0, 0}, {50, 0}, {0, 80}}, chargesOf({1, 0, -1}));
        QVERIFY((accelerationsIn(scene).row(1) == 0.0).all());
        QCOMPARE(chargesIn(scene).count(scene.start, {1, 1}), 0);
        std::vector<Coupling> couplings;
        chargesIn(scene).addCouplings(couplings);
        QVERIFY(couplings == (std::vector<Coupling>{{0, 2}}));
    }

    void coincidentChargesUseTheFallbackDirection()
    {
        const Scene scene = sceneOf({{7, 8}, {7, 8}}, chargesOf({2, 3}));
        const Vec2 pull = strength * 6.0 / (defaultSoftening * defaultSoftening) * fallbackDirection(1, 0);
        const Eigen::ArrayX2d accelerations = accelerationsIn(scene);
        QCOMPARE(accelerations(0, 0), pull.x);
        QCOMPARE(accelerations(0, 1), pull.y);
        QVERIFY((accelerations.row(0) == -accelerations.row(1)).all());
        const Eigen::ArrayX2d published = accelerationsIn(scene, DirectionRule::published);
        QCOMPARE(published(0, 0),
                 strength * 6.0 /
                     (defaultSoftening * defaultSoftening)); // to the right, because atan2(0, 0) is 0
        QCOMPARE(published(0, 1), 0.0);
    }

    void allPointsAtOnceAndOneByOneGiveTheSameBits_data()
    {
        QTest::addColumn<int>("points");
        for (const int points : {2, 5, 17, 120})
            QTest::addRow("%d points", points) << points;
    }
    void allPointsAtOnceAndOneByOneGiveTheSameBits()
    {
        QFETCH(int, points);
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            Scene scene = anyScene(points, seed);
            if (seed % 2 == 0)
                scene.start.inverseMass.setOnes(); // the loops have a branch for equal masses
            const Eigen::ArrayX2d all = accelerationsIn(scene);
            Eigen::ArrayX2d oneByOne = Eigen::ArrayX2d::Zero(points, 2);
            for (int i = 0; i < points; ++i)
                chargesIn(scene).add(scene.start, {i, 1}, 1.0, DirectionRule::regularised, oneByOne);
            QVERIFY(all.isFinite().all());
            QCOMPARE(std::memcmp(all.data(), oneByOne.data(),
                                 static_cast<std::size_t>(all.size()) * sizeof(double)),
                     0);
        }
    }

    void liveValuesEndWithTheAppliedPull()
    {
        const Scene pair = sceneOf({{30, 40}, {}}, chargesOf({2, -1}));
        const std::vector<LiveValue> live =
            chargesIn(pair).explain(pair.start, 0, DirectionRule::regularised);
        QStringList names;
        for (const LiveValue &value : live)
            names << QString::fromStdString(value.name);
        QCOMPARE(names, QStringList({"from", "length", "force", "pull"}));
        QCOMPARE(std::get<double>(live[1].value), 50.0);
        QCOMPARE(std::get<double>(live[2].value),
                 -2.0 * strength / (2500.0 + defaultSoftening * defaultSoftening));
        const Scene many = anyScene(9, 4);
        const Eigen::ArrayX2d accelerations = accelerationsIn(many);
        for (int i = 0; i < 9; ++i) {
            const std::vector<LiveValue> values =
                chargesIn(many).explain(many.start, i, DirectionRule::regularised);
            const Vec2 pull = values.empty() ? Vec2() : std::get<Vec2>(values.back().value);
            QVERIFY(length(pull - Vec2{accelerations(i, 0), accelerations(i, 1)}) < 1e-12);
        }
    }

    void chargesCanBeCopiedIntoADraft()
    {
        Blueprint blueprint;
        blueprint.points = {{"a", {0, 0}, {}}, {"b", {50, 0}, {}}, {"c", {0, 50}, {}}};
        blueprint.points[0].properties["charge"] = 2.5;
        blueprint.points[2].properties["charge"] = -1.0;
        blueprint.effects = {"charges"};
        Values values;
        values.set("charge_strength", 700.0);
        values.set("softening", 12.0);
        const ChosenEffects chosen = chosenEffects(allEffects(), blueprint, values);
        QCOMPARE(chosen.beforeMove.size(), std::size_t(1));
        BlueprintDraft draft;
        draft.state = State::ofPoints(3);
        draft.blueprint.points = {{"a", {0, 0}, {}}, {"b", {50, 0}, {}}, {"c", {0, 50}, {}}};
        QVERIFY(chosen.beforeMove.front()->addToDraft(draft));
        QVERIFY(draft.blueprint == blueprint);
        QCOMPARE(draft.parameters.at("charge_strength"), 700.0);
        QCOMPARE(draft.parameters.at("softening"), 12.0);
    }
};

SUITE(tst_charges, TestCharges)
#include "tst_charges.moc"
