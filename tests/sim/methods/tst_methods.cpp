// The methods against closed forms and against each other.

#include "sim/pipeline/pipeline.h"
#include "tests/sim/support/method_rows.h"
#include "tests/sim/support/support.h"

#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <set>

using namespace sim;

namespace {

/// Returns the order of convergence between the two smallest steps, which differ by a factor of 2.
double measuredOrder(const std::vector<double> &errors)
{
    return std::log2(errors[errors.size() - 2] / errors.back());
}

double stateDistance(const State &a, const State &b)
{
    return std::max((a.position - b.position).abs().maxCoeff(), (a.velocity - b.velocity).abs().maxCoeff());
}

/// Returns a creature in the air. No velocity jumps, so all methods have their order.
Scene smoothScene()
{
    Scene scene = scenes::springCreature(5, 0.1, 50.0);
    support::scatter(scene.start, 42, 400.0);
    scenes::add<Gravity>(scene, 0.5);
    scenes::add<Damping>(scene, 0.9);
    return scene;
}

Scene movingOscillator(double k, double damp)
{
    Scene scene = scenes::oscillator({100.0, -40.0}, {}, k, damp);
    scene.start.setVelocity(0, {3.0, 8.0});
    return scene;
}

}

class TestMethods : public QObject
{
    Q_OBJECT

private slots:
    void publishedAndSemiImplicitConvergeWithOrderOne()
    {
        const Scene scene = smoothScene();
        std::vector<double> errors;
        for (int n = 4; n <= 10; ++n) {
            const double h = std::ldexp(1.0, -n);
            errors.push_back(stateDistance(support::plainRun(scene, "published", h, 20),
                                           support::plainRun(scene, "semi_implicit_euler", h, 20)));
        }
        QVERIFY2(errors.back() > 1e-9, "the two methods compute the same: nothing is measured");
        QVERIFY2(std::abs(measuredOrder(errors) - 1.0) < 0.1,
                 qPrintable(QString::number(measuredOrder(errors))));
    }

    void methodsConvergeToTheDampedOscillator_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("k");
        QTest::addColumn<double>("damp");
        for (const MethodPtr &method : support::fixedMethods()) {
            const QString id = QString::fromStdString(method->id());
            const std::string title = method->title();
            QTest::addRow("%s, underdamped", title.c_str()) << id << 0.2 << 0.9;
            QTest::addRow("%s, overdamped", title.c_str()) << id << 0.05 << 0.5;
            QTest::addRow("%s, undamped", title.c_str()) << id << 0.2 << 1.0;
        }
    }
    void methodsConvergeToTheDampedOscillator()
    {
        QFETCH(QString, method);
        QFETCH(double, k);
        QFETCH(double, damp);
        const Scene scene = movingOscillator(k, damp);
        const double exact = support::dampedOscillation(100.0, 3.0, k, damp, 10.0);
        // Small enough for the order to show, large enough for rounding not to.
        const int order = findMethod(method.toStdString())->order();
        const int finest = order == 1 ? 10 : order == 2 ? 7 : 4;
        std::vector<double> errors;
        for (int n = finest - 3; n <= finest; ++n) {
            const State end = support::plainRun(scene, method.toStdString(), std::ldexp(1.0, -n), 10);
            errors.push_back(std::abs(end.positionOf(0).x - exact));
        }
        QVERIFY2(errors.back() < 0.1, qPrintable(QString::number(errors.back())));
        QVERIFY2(std::abs(measuredOrder(errors) - order) < 0.15,
                 qPrintable(QString::number(measuredOrder(errors))));
    }

    void dampingWithoutForceIsExactAtAnyStep_data() { support::addFixedMethodRows(); }
    void dampingWithoutForceIsExactAtAnyStep()
    {
        QFETCH(QString, method);
        Scene scene = movingOscillator(0.2, 0.9);
        scene.effects.erase(scene.effects.begin());
        for (const double h : {0.001, 0.125, 1.0 / 3, 1.0, 2.0, 10.0}) {
            const State end = support::plainRun(scene, method.toStdString(), h, 30);
            const double factor = std::pow(0.9, 30);
            // Each of the 30/h products is rounded once, and each factor is off by half a bit.
            const double tolerance = 1.2e-16 * 2 * (30 / h);
            QVERIFY2(std::abs(end.velocityOf(0).x / (3.0 * factor) - 1.0) < tolerance,
                     qPrintable(QString::number(h)));
            QVERIFY(std::abs(end.velocityOf(0).y / (8.0 * factor) - 1.0) < tolerance);
        }
    }

    void semiImplicitBoundsTheEnergyOfASpring_data()
    {
        QTest::addColumn<double>("k");
        QTest::newRow("soft") << 0.01;
        QTest::newRow("as in the lessons") << 0.2;
        QTest::newRow("stiff") << 2.0;
        QTest::newRow("near the limit of 4") << 3.9;
    }
    void semiImplicitBoundsTheEnergyOfASpring()
    {
        QFETCH(double, k);
        Scene scene = movingOscillator(k, 1.0);
        scene.effects.pop_back();
        const Pipeline frame = compose(scene, *findMethod("semi_implicit_euler"), StepSize::ofLength(1.0));
        State state = scene.start;
        findMethod("semi_implicit_euler")->prepareState(state);
        // Semi-implicit Euler conserves v^2 + k x^2 - h k x v to rounding, which bounds the energy: Hairer,
        // Lubich and Wanner, "Geometric numerical integration", section IX.3.
        const auto invariant = [&] {
            const Vec2 x = state.positionOf(0), v = state.velocityOf(0);
            return v.x * v.x + k * x.x * x.x - k * x.x * v.x;
        };
        const double start = invariant();
        const double root = std::sqrt(k);
        for (int i = 0; i < 100'000; ++i) {
            for (const Phase &phase : frame.phases)
                phase.run(state);
            const Vec2 x = state.positionOf(0), v = state.velocityOf(0);
            const double energy = v.x * v.x + k * x.x * x.x;
            QVERIFY(energy >= start / (1 + root / 2) * (1 - 1e-10));
            QVERIFY(energy <= start / (1 - root / 2) * (1 + 1e-10));
        }
        QVERIFY2(std::abs(invariant() / start - 1.0) < 1e-10,
                 qPrintable(QString::number(invariant() / start - 1.0)));
    }

    void symplecticMethodsBoundTheEnergyForAMillionFrames_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("expected"); // largest energy / smallest energy - 1
        // Each method conserves a quadratic form to rounding, which bounds the energy (Hairer, Lubich and
        // Wanner, "Geometric numerical integration", section IX.3). With k = 0.2 and h = 1: semi-implicit
        // Euler v^2 + k x^2 - h k x v; velocity Verlet v^2 + k (1 - h^2 k / 4) x^2; position Verlet (1 - h^2
        // k / 4) v^2 + k x^2.
        const double k = 0.2, root = std::sqrt(k);
        QTest::newRow("semi-implicit Euler") << "semi_implicit_euler" << (1 + root / 2) / (1 - root / 2) - 1;
        QTest::newRow("position Verlet") << "position_verlet" << 1 / (1 - k / 4) - 1;
        QTest::newRow("velocity Verlet") << "velocity_verlet" << 1 / (1 - k / 4) - 1;
    }
    void symplecticMethodsBoundTheEnergyForAMillionFrames()
    {
        QFETCH(QString, method);
        QFETCH(double, expected);
        Scene scene = movingOscillator(0.2, 1.0);
        scene.effects.pop_back();
        const MethodPtr rule = findMethod(method.toStdString());
        QVERIFY(rule->symplectic() == Symplectic::yes);
        rule->prepareState(scene.start);
        const Pipeline frame = compose(scene, *rule, StepSize::ofLength(1.0));
        State state = scene.start;
        struct EnergyRange
        {
            double lowest = HUGE_VAL, highest = 0.0, mean = 0.0;
        };
        const auto energyRange = [&](int frames) {
            EnergyRange range;
            for (int i = 0; i < frames; ++i) {
                for (const Phase &phase : frame.phases)
                    phase.run(state);
                const double energy = state.velocityOf(0).x * state.velocityOf(0).x +
                                      0.2 * state.positionOf(0).x * state.positionOf(0).x;
                range.lowest = std::min(range.lowest, energy);
                range.highest = std::max(range.highest, energy);
                range.mean += energy / frames;
            }
            return range;
        };
        const EnergyRange first = energyRange(10'000);
        energyRange(980'000);
        const EnergyRange last = energyRange(10'000);
        for (const EnergyRange &range : {first, last})
            QVERIFY2(std::abs((range.highest / range.lowest - 1) / expected - 1) < 0.02,
                     qPrintable(QString::number(range.highest / range.lowest - 1)));
        // The means differ by some parts in a million, depending on the phases at which the ranges begin and
        // end.
        QVERIFY2(std::abs(last.mean / first.mean - 1) < 1e-4,
                 qPrintable(QString::number(last.mean / first.mean - 1)));
        QVERIFY(std::abs(last.highest / first.highest - 1) < 1e-4);
    }

    void explicitEulerGainsEnergyAtEveryStep()
    {
        Scene scene = movingOscillator(0.2, 1.0);
        scene.effects.pop_back();
        for (const double h : {1.0, 0.25}) {
            const State end = support::plainRun(scene, "explicit_euler", h, 50);
            const double start = 3.0 * 3.0 + 0.2 * 100.0 * 100.0;
            const double energy =
                end.velocityOf(0).x * end.velocityOf(0).x + 0.2 * end.positionOf(0).x * end.positionOf(0).x;
            const double gain = std::pow(1.0 + 0.2 * h * h, 50 / h);
            QVERIFY2(std::abs(energy / (start * gain) - 1.0) < 1e-10, qPrintable(QString::number(energy)));
        }
    }

    void semiImplicitConservesTheMomentumOfACreature()
    {
        Scene scene = smoothScene();
        scene.effects.resize(1); // the springs
        for (int i = 0; i < scene.start.pointCount(); ++i)
            scene.start.setVelocity(i, {1.0 + i, -0.5 * i});
        const State end = support::plainRun(scene, "semi_implicit_euler", 1.0, 10'000);
        const double largest = end.velocity.abs().maxCoeff();
        for (int axis = 0; axis < 2; ++axis) {
            const double drift = end.velocity.col(axis).sum() - scene.start.velocity.col(axis).sum();
            // Twelve rounding errors per frame add up like a random walk: 1e-16 * 12 * sqrt(10^4), with a
            // margin.
            QVERIFY2(std::abs(drift) < 1e-12 * largest, qPrintable(QString::number(drift)));
        }
    }

    void middleOfAStickFallsFreely_data() { support::addFixedMethodRows(); }
    void middleOfAStickFallsFreely()
    {
        // The stick turns as it falls. The constraint must not change the fall of its middle.
        QFETCH(QString, method);
        Scene scene = scenes::pointsAt({{240, 200}, {300, 200}});
        scene.start.setVelocity(0, {0, 1});
        scene.start.setVelocity(1, {0, -1});
        scene.effects = {std::make_shared<Gravity>(0.5),
                         std::make_shared<Sticks>(std::vector<Stick>{{0, 1, 60.0, 0.5}}, 2)};
        if (!support::fits(scene, *findMethod(method.toStdString())))
            return; // implicit methods refuse sticks
        const double h = 1.0 / 8, time = 40.0, freeFall = 0.5 * 0.5 * time * time;
        const State end = support::plainRun(scene, method.toStdString(), h, int(time));
        const double fallen = 0.5 * (end.positionOf(0).y + end.positionOf(1).y) - 200.0;
        // Euler methods apply the force at one end of the step, which adds or removes half a step.
        const double expectedError = findMethod(method.toStdString())->order() == 1 ? 0.25 * time * h : 0.0;
        QVERIFY2(std::abs(std::abs(fallen - freeFall) - expectedError) < 1e-9,
                 qPrintable(QString::number(fallen - freeFall)));
        QVERIFY(std::abs(length(end.positionOf(0) - end.positionOf(1)) - 60.0) < 1e-9);
    }

    void publishedPairPropelsItself()
    {
        // The published method moves one point after the other, so the pair flies off at k = 0.3, damp = 0.9.
        Scene scene = scenes::springCreature(1, 0.3, 50.0);
        scene.start.place(0, {300, 230});
        scenes::add<Damping>(scene, 0.9);
        QVERIFY(support::plainRun(scene, "published", 1.0, 2000).velocity.matrix().norm() > 10.0);
        QVERIFY(support::plainRun(scene, "semi_implicit_euler", 1.0, 2000).velocity.matrix().norm() < 1e-6);
    }

    void springsBetweenDifferentMassesConserveMomentum()
    {
        Scene scene = support::script(support::sample("heavy pair"), "published")
                          .build(support::sample("heavy pair").values);
        scene.effects.pop_back();
        const State end = support::plainRun(scene, "semi_implicit_euler", 0.25, 200);
        const auto momentum = [&](const State &s, int axis) {
            return (s.velocity.col(axis) / s.inverseMass).sum();
        };
        for (int axis = 0; axis < 2; ++axis)
            QVERIFY(std::abs(momentum(end, axis)) < 1e-10);
    }

    void methodsHaveUniqueIdsAndValidProperties()
    {
        std::set<std::string> knownIds, titles;
        for (const MethodPtr &method : allMethods()) {
            QCOMPARE(findMethod(method->id())->title(), method->title());
            QVERIFY(knownIds.insert(method->id()).second && titles.insert(method->title()).second);
            QVERIFY(method->order() >= 1 && !method->region().file.empty());
        }
        QVERIFY(!findMethod("no such method"));
    }
};

SUITE(tst_methods, TestMethods)
#include "tst_methods.moc"
