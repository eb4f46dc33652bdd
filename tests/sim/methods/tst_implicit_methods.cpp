// Implicit methods: order, conservation, and stability at any stiffness.

#include "sim/pipeline/pipeline.h"
#include "sim/run/finite.h"
#include "tests/sim/support/implicit_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drags/split_damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using namespace implicit_scenes;

namespace {

const char *const implicitMethods[] = {"backward_euler", "implicit_midpoint", "tr_bdf2"};

template <class Visit>
State runOf(const Scene &scene, const std::string &method, double h, int frames, Visit &&visit)
{
    const MethodPtr rule = findMethod(method);
    const Pipeline pipeline = compose(scene, *rule, StepSize::ofLength(h));
    State state = scene.start;
    rule->prepareState(state);
    for (int frame = 0; frame < frames; frame += pipeline.step.framesPerOutput) {
        for (int i = 0; i < pipeline.phasesPerOutput(); ++i)
            pipeline.phaseAt(i).run(state);
        visit(state);
    }
    return state;
}

std::string refusalOf(const Scene &scene, const std::string &method)
{
    try {
        compose(scene, *findMethod(method), StepSize::ofLength(1.0));
    } catch (const Error &error) {
        return error.id() + (error.values().contains("effect") ? " " + error.values().at("effect") : "");
    }
    return "accepted";
}

}

class TestImplicitMethods : public QObject
{
    Q_OBJECT

private:
    static void addMethodRows()
    {
        QTest::addColumn<QString>("method");
        for (const char *id : implicitMethods)
            QTest::newRow(id) << id;
    }

private slots:
    void errorShrinksWithTheStatedOrder_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("number");
        for (const char *id : implicitMethods) {
            for (std::size_t i = 0; i < smoothScenes().size(); ++i)
                QTest::addRow("%s, %s", id, smoothScenes()[i].name.c_str()) << id << int(i);
        }
    }
    void errorShrinksWithTheStatedOrder()
    {
        QFETCH(QString, method);
        QFETCH(int, number);
        const SmoothScene &smooth = smoothScenes()[std::size_t(number)];
        constexpr int frames = 10;
        const Coordinates exact = smooth.exact(frames);
        std::vector<double> errors;
        for (const int n : {5, 6, 7})
            errors.push_back(distance(coordinatesOf(support::plainRun(smooth.scene, method.toStdString(),
                                                                      std::ldexp(1.0, -n), frames)),
                                      exact));
        const int order = findMethod(method.toStdString())->order();
        const double measured = std::log2(errors[1] / errors[2]);
        QVERIFY2(std::abs(measured - order) < 0.15, qPrintable(QString("order %1, errors %2 %3 %4")
                                                                   .arg(measured)
                                                                   .arg(errors[0])
                                                                   .arg(errors[1])
                                                                   .arg(errors[2])));
    }

    void oneStepIsTheClosedFormOfALinearSpring()
    {
        const double k = 0.7, damp = 0.8, h = 0.5;
        const Scene scene = oscillator(k, damp);
        const double factor = std::pow(damp, h), x = 100.0, v = 3.0;
        const auto step = [&](const char *method) {
            State state = scene.start;
            findMethod(method)->prepareState(state);
            for (const Phase &phase : compose(scene, *findMethod(method), StepSize::ofLength(h)).phases)
                phase.run(state);
            return state;
        };
        // x1 = x + h damp^h (v - h k x1), solved for x1
        const double x1 = (x + h * factor * v) / (1 + h * h * k * factor);
        const State euler = step("backward_euler");
        QVERIFY(std::abs(euler.positionOf(0).x - x1) < 1e-12);
        QVERIFY(std::abs(euler.velocityOf(0).x - (x1 - x) / h) < 1e-12);
        // Cayley's form of the rotation: the mean velocity is m = (v - h/2 k x) / (1 + h^2/4 k).
        const double slowed = std::sqrt(factor) * v;
        const double middle = (slowed - h / 2 * k * x) / (1 + h * h / 4 * k);
        const State midpoint = step("implicit_midpoint");
        QVERIFY(std::abs(midpoint.positionOf(0).x - (x + h * middle)) < 1e-12);
        QVERIFY(std::abs(midpoint.velocityOf(0).x - std::sqrt(factor) * (2 * middle - slowed)) < 1e-12);
    }

    void dampingAloneIsExactAtAnyStep_data() { addMethodRows(); }
    void dampingAloneIsExactAtAnyStep()
    {
        QFETCH(QString, method);
        Scene scene = oscillator(0.2, 0.9);
        scene.effects.erase(scene.effects.begin());
        for (const double h : {0.001, 0.125, 1.0 / 3, 1.0, 2.0, 10.0}) {
            const State end = support::plainRun(scene, method.toStdString(), h, 30);
            const double factor = std::pow(0.9, 30);
            // Two factors per step, each off by one bit and rounded once more. c is rounded, too.
            const double tolerance = 2.3e-16 * (3 * (30 / h) + 30 * 0.11);
            QVERIFY2(std::abs(end.velocityOf(0).x / (3.0 * factor) - 1.0) < tolerance,
                     qPrintable(QString::number(h)));
            QVERIFY(std::abs(end.velocityOf(0).y / (8.0 * factor) - 1.0) < tolerance);
        }
    }

    void fullDampingStopsAtOnce_data() { addMethodRows(); }
    void fullDampingStopsAtOnce()
    {
        QFETCH(QString, method);
        const Scene scene = oscillator(0.2, 0.0);
        for (const double h : {0.25, 1.0, 3.0}) {
            const State end = support::plainRun(scene, method.toStdString(), h, 12);
            QCOMPARE(end.positionOf(0), scene.start.positionOf(0));
            QCOMPARE(end.velocityOf(0), Vec2());
        }
    }

    void dampingFactorOneChangesNothing_data() { addMethodRows(); }
    void dampingFactorOneChangesNothing()
    {
        QFETCH(QString, method);
        Scene scene = creature(5, 1.0);
        const State damped = support::plainRun(scene, method.toStdString(), 0.5, 40);
        scene.effects.pop_back();
        const State bare = support::plainRun(scene, method.toStdString(), 0.5, 40);
        QCOMPARE(support::difference(damped, bare), std::string());
    }

    void implicitMidpointConservesTheEnergyOfASpring_data()
    {
        QTest::addColumn<double>("k");
        QTest::newRow("as in the lessons") << 0.2;
        QTest::newRow("far stiffer than the step follows") << 1e4;
    }
    void implicitMidpointConservesTheEnergyOfASpring()
    {
        QFETCH(double, k);
        Scene scene = oscillator(k, 1.0);
        const auto energy = [&](const State &state) {
            const Vec2 x = state.positionOf(0), v = state.velocityOf(0);
            return v.x * v.x + v.y * v.y + k * (x.x * x.x + x.y * x.y);
        };
        const double start = energy(scene.start);
        double maxError = 0.0;
        runOf(scene, "implicit_midpoint", 1.0, 1'000'000, [&](const State &state) {
            maxError = std::max(maxError, std::abs(energy(state) / start - 1.0));
        });
        // At worst the rounding errors of 1e-16 per step all have the same sign.
        QVERIFY2(maxError < 1e-10, qPrintable(QString::number(maxError)));
    }

    void implicitMidpointIsReversible_data()
    {
        QTest::addColumn<bool>("isWalking");
        QTest::newRow("a creature in the air") << false;
        QTest::newRow("legs that swing") << true;
    }
    void implicitMidpointIsReversible()
    {
        QFETCH(bool, isWalking);
        const Scene scene = isWalking ? walker(1.0) : creature(5, 1.0);
        const auto errorAfterReturn = [&](const char *method) {
            Scene back = scene;
            back.start = support::plainRun(scene, method, 0.5, 20);
            back.start.velocity *= -1.0;
            back.start.gaitSpeed *= -1.0;
            const State end = support::plainRun(back, method, 0.5, 20);
            return (end.position - scene.start.position).abs().maxCoeff();
        };
        QVERIFY2(errorAfterReturn("implicit_midpoint") < 1e-8,
                 qPrintable(QString::number(errorAfterReturn("implicit_midpoint"))));
        QVERIFY(errorAfterReturn("backward_euler") > 1.0);
    }

    void stiffSpringsComeToRestAtTheirExactPositions_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("k");
        for (const QString id : {"backward_euler", "tr_bdf2"}) {
            for (const double k : {1.0, 1e3, 1e6, 1e9})
                QTest::addRow("%s, k = %g", qPrintable(id), k) << id << k;
        }
    }
    void stiffSpringsComeToRestAtTheirExactPositions()
    {
        QFETCH(QString, method);
        QFETCH(double, k);
        const Scene scene = hanging(k, 0.85);
        double maxDistance = 0.0;
        const State end = runOf(scene, method.toStdString(), 1.0, 600, [&](const State &state) {
            maxDistance = std::max(maxDistance, (state.position - 200.0).abs().maxCoeff());
        });
        QVERIFY2(maxDistance < 400.0, qPrintable(QString::number(maxDistance)));
        // A force is rounded to k times the last bit of 256 px. Sideways only gravity restores, by 0.5 / 50
        // per px.
        const double tolerance = 1e-6, sidewaysTolerance = 1e-6 + k * 2.9e-14 / 0.01 * 4;
        const Vec2 hangingBelow[] = {end.positionOf(0) - Vec2{200.0, 200.0},
                                     end.positionOf(3) - end.positionOf(1)};
        for (const Vec2 offset : hangingBelow) {
            QVERIFY2(std::abs(offset.x) < sidewaysTolerance, qPrintable(QString::number(offset.x)));
            QVERIFY2(std::abs(length(offset) - (50.0 + gravity / k)) < tolerance,
                     qPrintable(QString::number(length(offset), 'g', 15)));
            QVERIFY(offset.y > 0.0);
        }
        // the upper point carries both weights
        QVERIFY(std::abs(length(end.positionOf(1) - end.positionOf(5)) - (50.0 + 2 * gravity / k)) <
                tolerance);
        QVERIFY(length(end.positionOf(2) - Vec2{120.0, 150.0 + gravity / k}) < 1e-9);
        QVERIFY2(end.velocity.abs().maxCoeff() < sidewaysTolerance,
                 qPrintable(QString::number(end.velocity.abs().maxCoeff())));
    }

    void stiffModeIsDampedByTwoMethodsAndKeptByOne()
    {
        constexpr double k = 1e4;
        const Scene scene = oscillator(k, 1.0);
        const auto energy = [k](const State &state) {
            return (state.velocity.square() + k * state.position.square()).sum();
        };
        const auto remaining = [&](const char *method) {
            return energy(support::plainRun(scene, method, 1.0, 20)) / energy(scene.start);
        };
        QVERIFY(remaining("backward_euler") < 1e-12);
        QVERIFY(remaining("tr_bdf2") < 1e-12);
        QVERIFY(std::abs(remaining("implicit_midpoint") - 1.0) < 1e-12);
    }

    void repeatedRunsHaveTheSameBits_data() { addMethodRows(); }
    void repeatedRunsHaveTheSameBits()
    {
        QFETCH(QString, method);
        for (const int feet : {5, 40}) { // few and many unknowns use different solvers
            const Scene scene = creature(feet, 0.9);
            const State first = support::plainRun(scene, method.toStdString(), 1.0, 100);
            const State second = support::plainRun(scene, method.toStdString(), 1.0, 100);
            QVERIFY(sameBits(first, second));
            QCOMPARE(firstNonFinitePoint(first), -1);
            QVERIFY(first.forceEvaluations() >= 200 && first.forceEvaluations() < 100 * 50);
        }
    }

    void heldPointPullsAndDoesNotMove_data() { addMethodRows(); }
    void heldPointPullsAndDoesNotMove()
    {
        QFETCH(QString, method);
        Scene scene = creature(2, 0.7);
        scene.effects.erase(scene.effects.begin() + 1); // gravity
        Script script = support::script(scene, method.toStdString());
        script.input = {{0, Grab{"foot0"}}, {0, Move{{100.0, 100.0}}}};
        Track track(script, 100'000);
        track.seek({400, 0});
        QCOMPARE(track.state().positionOf(0), (Vec2{100.0, 100.0}));
        const double springLength = length(track.state().positionOf(2) - track.state().positionOf(0));
        QVERIFY2(std::abs(springLength - 50.0) < 1e-6, qPrintable(QString::number(springLength)));
    }

    void swayOfATreeAgreesBetweenMethods()
    {
        const Scene scene = windyTree();
        const State first = support::plainRun(scene, "implicit_midpoint", 1.0 / 64, 60);
        const State second = support::plainRun(scene, "tr_bdf2", 1.0 / 64, 60);
        const State plain = support::plainRun(scene, "semi_implicit_euler", 1.0 / 4096, 60);
        QVERIFY((first.angle - scene.start.angle).abs().maxCoeff() > 5.0); // the tree does sway
        QVERIFY((first.angle - second.angle).abs().maxCoeff() < 0.01);
        QVERIFY((first.angle - plain.angle).abs().maxCoeff() < 0.02);
        QVERIFY((first.position - plain.position).abs().maxCoeff() < 0.02);
        for (const char *method : implicitMethods)
            QCOMPARE(firstNonFinitePoint(support::plainRun(scene, method, 2.0, 600)), -1);
    }

    void allForcesAreSolvedInOnePhase()
    {
        const support::Sample &walkers = support::sample("walkers");
        const Scene scene = walkers.build(walkers.values);
        std::string phases;
        std::string innerEffects;
        for (const Phase &phase : compose(scene, *findMethod("tr_bdf2"), StepSize::ofLength(1.0)).phases) {
            phases += phase.id + " ";
            for (const EffectPtr &effect : phase.innerEffects)
                innerEffects += effect->id() + " ";
        }
        QCOMPARE(phases, std::string("steering solve ground walls turn_round "));
        QCOMPARE(innerEffects, std::string("leg_spring push gravity damping gait_clock "));
    }

    void effectsWithoutEquationsAreRefused_data() { addMethodRows(); }
    void effectsWithoutEquationsAreRefused()
    {
        QFETCH(QString, method);
        const std::string id = method.toStdString();
        Scene scene = creature(2, 0.9);
        QCOMPARE(refusalOf(scene, id), std::string("accepted"));
        scene.effects.push_back(std::make_shared<SplitDamping>(0, 1, 0.7, 0.5));
        QCOMPARE(refusalOf(scene, id), std::string("method-does-not-fit split_damping"));
        scene.effects.back() = std::make_shared<Sticks>(std::vector<Stick>{{}}, 3);
        QCOMPARE(refusalOf(scene, id), std::string("method-does-not-fit sticks"));
        scene.effects.pop_back();
        scene.groups.front().motion = Motion::prescribed;
        QCOMPARE(refusalOf(scene, id), std::string("needs-inertia"));
    }
};

SUITE(tst_implicit_methods, TestImplicitMethods)
#include "tst_implicit_methods.moc"
