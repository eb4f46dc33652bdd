// Charges: the force law, its derivative and its energy against independent numbers, and that only charged points act.

#include "sim/pipeline/pipeline.h"
#include "support.h"

#include "sim/effects/all_effects.h"
#include "sim/effects/fields/charges.h"
#include "sim/methods/methods.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"

#include <QTest>

#include <cstring>
#include <numbers>

using namespace sim;
using support::Dice;

namespace {

constexpr double strength = 1000.0, soft = 10.0;

Eigen::ArrayXd chargesOf(std::initializer_list<double> charges)
{
    Eigen::ArrayXd all(static_cast<Eigen::Index>(charges.size()));
    std::copy(charges.begin(), charges.end(), all.begin());
    return all;
}

/// A scene of these points, with those charges and nothing else.
Scene sceneOf(const std::vector<Vec2> &places, const Eigen::ArrayXd &charge, double softening = soft)
{
    Scene scene = scenes::pointsAt(places);
    scenes::add<Charges>(scene, charge, strength, softening);
    return scene;
}

const Charges &chargesIn(const Scene &scene)
{
    return dynamic_cast<const Charges &>(*scene.effects.front());
}

Eigen::ArrayX2d pullsIn(const Scene &scene, DirectionRule directionRule = DirectionRule::regularised)
{
    Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(scene.start.pointCount(), 2);
    chargesIn(scene).add(scene.start, {0, scene.start.pointCount()}, 1.0, directionRule, sum);
    return sum;
}

/// Potential and kinetic.
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

/// Points with charges of both signs, masses, nails and two points in one place.
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
    void twoChargesFeelTheProductOverTheSoftenedSquare_data()
    {
        QTest::addColumn<double>("q1");
        QTest::addColumn<double>("q2");
        QTest::addColumn<double>("distance");
        QTest::newRow("like charges repel") << 1.0 << 2.0 << 50.0;
        QTest::newRow("so do two negative ones") << -1.5 << -2.0 << 50.0;
        QTest::newRow("unlike charges attract") << 3.0 << -0.5 << 120.0;
        QTest::newRow("nearer than the softening") << 1.0 << 1.0 << 0.001;
        QTest::newRow("very far away") << 1.0 << 1.0 << 1e200;
    }
    void twoChargesFeelTheProductOverTheSoftenedSquare()
    {
        QFETCH(double, q1);
        QFETCH(double, q2);
        QFETCH(double, distance);
        const double mass = 2.0;
        Scene scene = sceneOf({{0.6 * distance, 0.8 * distance}, {}}, chargesOf({q1, q2}));
        scene.start.inverseMass[0] = 1.0 / mass;
        const double force = strength * q1 * q2 / (distance * distance + soft * soft);
        for (const DirectionRule directionRule : {DirectionRule::regularised, DirectionRule::published}) {
            const Eigen::ArrayX2d pulls = pullsIn(scene, directionRule);
            QVERIFY(std::abs(pulls(0, 0) - 0.6 * force / mass) <= 1e-12 * std::abs(force));
            QVERIFY(std::abs(pulls(0, 1) - 0.8 * force / mass) <= 1e-12 * std::abs(force));
            QVERIFY((pulls.row(0) * mass == -pulls.row(1)).all());
        }
    }

    void theForceChangesByItsSlopes_data()
    {
        QTest::addColumn<double>("q");
        QTest::newRow("like charges") << 1.5;
        QTest::newRow("unlike charges") << -1.5;
    }
    void theForceChangesByItsSlopes()
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
                continue; // there pulls turn too fast for differences
            Jacobian jacobian(3);
            QVERIFY(
                chargesIn(scene).addJacobian(scene.start, {0, 3}, 1.0, DirectionRule::regularised, jacobian));
            Eigen::MatrixXd told = Eigen::MatrixXd::Zero(6, 6);
            for (const Jacobian::Entry &entry : jacobian.entries())
                told(entry.row, entry.column) += entry.value;
            for (int column = 0; column < 6; ++column) {
                const auto pullsAt = [&](double by) -> Eigen::VectorXd {
                    Scene moved = scene;
                    moved.start.position.data()[column] += by;
                    return pullsIn(moved).reshaped().matrix();
                };
                const double step = 1e-3;
                const Eigen::VectorXd found =
                    (8.0 * (pullsAt(step) - pullsAt(-step)) - (pullsAt(2.0 * step) - pullsAt(-2.0 * step))) /
                    (12.0 * step);
                QVERIFY((told.col(column) - found).cwiseAbs().maxCoeff() < 1e-8);
            }
        }
    }

    void slopesAreFiniteWhereAllIsInOnePlace()
    {
        const Scene scene = sceneOf({{1, 2}, {1, 2}}, chargesOf({1, -1}));
        Jacobian jacobian(2);
        QVERIFY(chargesIn(scene).addJacobian(scene.start, {0, 2}, 1.0, DirectionRule::regularised, jacobian));
        for (const Jacobian::Entry &entry : jacobian.entries())
            QVERIFY(std::isfinite(entry.value));
    }

    void theStoredEnergyIsTheWorkOfTheForce_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::newRow("from one place") << 0.0 << 30.0;
        QTest::newRow("near") << 5.0 << 40.0;
        QTest::newRow("far") << 200.0 << 900.0;
    }
    void theStoredEnergyIsTheWorkOfTheForce()
    {
        QFETCH(double, from);
        QFETCH(double, to);
        const auto sceneAt = [](double x) { return sceneOf({{x, 0}, {}}, chargesOf({1.5, 2.0})); };
        const auto energyAt = [&](double x) {
            const Scene scene = sceneAt(x);
            return chargesIn(scene).potentialEnergy(scene.start).value();
        };
        const auto forceAt = [&](double x) { return pullsIn(sceneAt(std::max(x, 1e-9)))(0, 0); };
        const int parts = 2000;
        const double step = (to - from) / parts;
        double work = forceAt(from) + forceAt(to); // Simpson's rule
        for (int i = 1; i < parts; ++i)
            work += (i % 2 == 1 ? 4.0 : 2.0) * forceAt(from + i * step);
        work *= step / 3.0;
        QVERIFY(std::abs(energyAt(from) - energyAt(to) - work) < 1e-7 * work);
    }

    void farApartTheyStoreNothing()
    {
        const Scene scene = sceneOf({{1e12, 0}, {}}, chargesOf({1, 1}));
        QVERIFY(std::abs(chargesIn(scene).potentialEnergy(scene.start).value() - strength / 1e12) < 1e-18);
    }

    /// Verlet's error of the energy does not grow, and goes with the square of the step.
    void verletKeepsTheEnergy()
    {
        Scene scene = sceneOf({{200, 200}, {330, 200}, {260, 300}}, chargesOf({2, -1, 1.5}));
        scene.start.inverseMass << 1.0, 0.5, 2.0;
        scene.start.setVelocity(0, {0.5, -0.3});
        const double start = energyOf(scene, scene.start);
        const auto worst = [&](double h) {
            double most = 0.0;
            for (int frames = 20; frames <= 200; frames += 20)
                most = std::max(most, std::abs(energyOf(scene, after(scene, "velocity_verlet",
                                                                     StepSize::ofLength(h), frames)) -
                                               start));
            return most;
        };
        const double coarse = worst(0.125), fine = worst(0.0625);
        QVERIFY2(coarse < 1e-2 * std::abs(start), qPrintable(QString::number(coarse)));
        QVERIFY2(coarse / fine > 3.5 && coarse / fine < 4.5, qPrintable(QString::number(coarse / fine)));
    }

    void twoChargesKeepTheirMomentumExactly()
    {
        for (const double q : {1.0, -1.0}) {
            const Scene scene = sceneOf({{200, 200}, {300, 230}}, chargesOf({2, q}));
            const State end = after(scene, "semi_implicit_euler", StepSize::ofLength(1.0), 200);
            QVERIFY((end.velocity.row(0) != 0.0).any());
            QVERIFY((end.velocity.row(0) == -end.velocity.row(1)).all());
        }
    }

    /// In a circle the attraction is the centripetal force: w^2 d = K (1/m1 + 1/m2) / (d^2 + s^2).
    void unlikeChargesOrbitInTheRightTime_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("softening");
        QTest::newRow("hardly softened: Kepler's third law") << 100.0 << 1.0;
        QTest::newRow("softened") << 100.0 << 40.0;
        QTest::newRow("within the softening") << 30.0 << 60.0;
    }
    void unlikeChargesOrbitInTheRightTime()
    {
        QFETCH(double, distance);
        QFETCH(double, softening);
        const double m1 = 1.0, m2 = 3.0, period = 200.0;
        const double turn = 2.0 * std::numbers::pi / period;
        const double attraction =
            turn * turn * distance * (distance * distance + softening * softening) / (1.0 / m1 + 1.0 / m2);
        const double x1 = distance * m2 / (m1 + m2), x2 = distance * m1 / (m1 + m2);
        Scene scene = sceneOf({{x1, 0}, {-x2, 0}}, chargesOf({attraction / strength, -1.0}), softening);
        scene.start.inverseMass << 1.0 / m1, 1.0 / m2;
        scene.start.setVelocity(0, {0, turn * x1});
        scene.start.setVelocity(1, {0, -turn * x2});
        const State half = after(scene, "dop853", StepSize::withTolerance(1e-10), 100);
        QVERIFY(length(half.positionOf(0) - Vec2{-x1, 0}) < 1e-6);
        const State whole = after(scene, "dop853", StepSize::withTolerance(1e-10), 200);
        QVERIFY(length(whole.positionOf(0) - Vec2{x1, 0}) < 1e-6);
        QVERIFY(length(whole.positionOf(1) - Vec2{-x2, 0}) < 1e-6);
    }

    void withoutTwoChargesThereIsNoPhase_data()
    {
        QTest::addColumn<QList<double>>("charges");
        QTest::addColumn<double>("given");
        QTest::addColumn<bool>("acts");
        QTest::newRow("no charge") << QList<double>{0, 0, 0} << strength << false;
        QTest::newRow("one charge") << QList<double>{0, 2, 0} << strength << false;
        QTest::newRow("no strength") << QList<double>{1, 2, 3} << 0.0 << false;
        QTest::newRow("two charges") << QList<double>{1, 0, -1} << strength << true;
    }
    void withoutTwoChargesThereIsNoPhase()
    {
        QFETCH(QList<double>, charges);
        QFETCH(double, given);
        QFETCH(bool, acts);
        Scene scene = sceneOf({{0, 0}, {50, 0}, {0, 80}}, chargesOf({0, 0, 0}));
        scene.effects = {
            std::make_shared<Charges>(Eigen::Map<const Eigen::ArrayXd>(charges.data(), 3), given, soft)};
        const Pipeline pipeline = compose(scene, *findMethod("semi_implicit_euler"), StepSize::ofLength(1.0));
        const auto isTheirs = [&](const Phase &phase) { return phase.effect == scene.effects.front(); };
        QCOMPARE(std::any_of(pipeline.phases.begin(), pipeline.phases.end(), isTheirs), acts);
        QCOMPARE(pipeline.idleEffects.empty(), acts);
    }

    void whatCarriesNoChargeFeelsNothing()
    {
        const Scene scene = sceneOf({{0, 0}, {50, 0}, {0, 80}}, chargesOf({1, 0, -1}));
        QVERIFY((pullsIn(scene).row(1) == 0.0).all());
        QCOMPARE(chargesIn(scene).count(scene.start, {1, 1}), 0);
        std::vector<Coupling> ties;
        chargesIn(scene).addCouplings(ties);
        QVERIFY(ties == (std::vector<Coupling>{{0, 2}}));
    }

    void inOnePlaceTheyPartAsAllPairsDo()
    {
        const Scene scene = sceneOf({{7, 8}, {7, 8}}, chargesOf({2, 3}));
        const Vec2 pull = strength * 6.0 / (soft * soft) * fallbackDirection(1, 0);
        const Eigen::ArrayX2d pulls = pullsIn(scene);
        QCOMPARE(pulls(0, 0), pull.x);
        QCOMPARE(pulls(0, 1), pull.y);
        QVERIFY((pulls.row(0) == -pulls.row(1)).all());
        const Eigen::ArrayX2d published = pullsIn(scene, DirectionRule::published);
        QCOMPARE(published(0, 0), strength * 6.0 / (soft * soft)); // to the right, as atan2(0, 0) has it
        QCOMPARE(published(0, 1), 0.0);
    }

    void allAtOnceAndOneByOneHaveTheSameBits_data()
    {
        QTest::addColumn<int>("points");
        for (const int points : {2, 5, 17, 120})
            QTest::addRow("%d points", points) << points;
    }
    void allAtOnceAndOneByOneHaveTheSameBits()
    {
        QFETCH(int, points);
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            Scene scene = anyScene(points, seed);
            if (seed % 2 == 0)
                scene.start.inverseMass.setOnes(); // all loops have a form for this
            const Eigen::ArrayX2d whole = pullsIn(scene);
            Eigen::ArrayX2d single = Eigen::ArrayX2d::Zero(points, 2);
            for (int i = 0; i < points; ++i)
                chargesIn(scene).add(scene.start, {i, 1}, 1.0, DirectionRule::regularised, single);
            QVERIFY(whole.isFinite().all());
            QCOMPARE(std::memcmp(whole.data(), single.data(),
                                 static_cast<std::size_t>(whole.size()) * sizeof(double)),
                     0);
        }
    }

    void theLiveValuesAreThoseOfThePull()
    {
        const Scene pair = sceneOf({{30, 40}, {}}, chargesOf({2, -1}));
        const std::vector<LiveValue> live =
            chargesIn(pair).explain(pair.start, 0, DirectionRule::regularised);
        QStringList names;
        for (const LiveValue &one : live)
            names << QString::fromStdString(one.name);
        QCOMPARE(names, QStringList({"from", "length", "force", "pull"}));
        QCOMPARE(std::get<double>(live[1].value), 50.0);
        QCOMPARE(std::get<double>(live[2].value), -2.0 * strength / (2500.0 + soft * soft));
        const Scene many = anyScene(9, 4);
        const Eigen::ArrayX2d pulls = pullsIn(many);
        for (int i = 0; i < 9; ++i) {
            const std::vector<LiveValue> told =
                chargesIn(many).explain(many.start, i, DirectionRule::regularised);
            const Vec2 pull = told.empty() ? Vec2() : std::get<Vec2>(told.back().value);
            QVERIFY(length(pull - Vec2{pulls(i, 0), pulls(i, 1)}) < 1e-12);
        }
    }

    void whatIsBuiltCanBeTakenOver()
    {
        Blueprint plan;
        plan.points = {{"a", {0, 0}, {}}, {"b", {50, 0}, {}}, {"c", {0, 50}, {}}};
        plan.points[0].properties["charge"] = 2.5;
        plan.points[2].properties["charge"] = -1.0;
        plan.effects = {"charges"};
        Values values;
        values.set("charge_strength", 700.0);
        values.set("softening", 12.0);
        const ChosenEffects chosen = chosenEffects(allEffects(), plan, values);
        QCOMPARE(chosen.beforeMove.size(), std::size_t(1));
        BlueprintDraft draft;
        draft.state = State::ofPoints(3);
        draft.blueprint.points = {{"a", {0, 0}, {}}, {"b", {50, 0}, {}}, {"c", {0, 50}, {}}};
        QVERIFY(chosen.beforeMove.front()->addToDraft(draft));
        QVERIFY(draft.blueprint == plan);
        QCOMPARE(draft.parameters.at("charge_strength"), 700.0);
        QCOMPARE(draft.parameters.at("softening"), 12.0);
    }
};

QTEST_APPLESS_MAIN(TestCharges)
#include "tst_charges.moc"
