// Remedies for a stopped run. The smallest sufficient change of each kind follows from the eigenvalues of the
// scenes.

#include "tests/sim/support/stability_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/stability/remedies/trial_runs.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/methods/methods.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using stability_scenes::findRemedy;

namespace {

const ShouldContinue neverCancel = [] { return true; };
const DampRange dampRange = {"damp", 0.0, 0.01};

/// Returns a body with `feet` feet on linear springs of length 0. The squared frequency of feet against body
/// is (feet + 1) k.
Script linearStar(int feet, const char *method = "semi_implicit_euler")
{
    support::Sample sample;
    sample.values.set("k", 0.2);
    sample.values.set("damp", 0.85);
    sample.build = [feet](const Values &values) {
        Scene scene = scenes::linearCreature(feet, values["k"]);
        support::scatter(scene.start, 3, 200.0);
        scenes::add<Damping>(scene, values["damp"]);
        return scene;
    };
    return support::script(sample, method);
}

/// Returns whether semi-implicit Euler is stable: v' = d (v - h w^2 x), x' = x + h v' has |eigenvalues| < 1
/// if and only if h^2 w^2 < 2 (1 + 1/d), with d = damp^h.
bool isStable(double squaredFrequency, double h, double damp)
{
    return h * h * squaredFrequency < 2.0 * (1.0 + std::pow(damp, -h));
}

Stop stopOf(const Script &script)
{
    Track track(script, 1 << 20);
    track.seek({100'000, 0});
    return track.stop().value();
}

}

class TestTrialRuns : public QObject
{
    Q_OBJECT

private slots:
    void smallestSufficientChangeIsFound_data()
    {
        QTest::addColumn<int>("feet");
        for (const int feet : {25, 60, 200, 500})
            QTest::addRow("%d feet", feet) << feet;
    }
    void smallestSufficientChangeIsFound()
    {
        QFETCH(int, feet);
        const Script script = linearStar(feet);
        const double squaredFrequency = 0.2 * (feet + 1);
        QVERIFY(!isStable(squaredFrequency, 1.0, 0.85));
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        double h = 0.5;
        while (!isStable(squaredFrequency, h, 0.85))
            h /= 2.0;
        const Remedy *smaller = findRemedy(found, Remedy::Kind::smallerStep);
        QVERIFY(smaller && smaller->stableFrames > 0);
        QCOMPARE(smaller->step.h, h);
        double newDamp = 0.85;
        do {
            newDamp = std::max(0.01, std::floor(100.0 * newDamp * newDamp) / 100.0);
        } while (!isStable(squaredFrequency, 1.0, newDamp) && newDamp > 0.01);
        const Remedy *moreDamping = findRemedy(found, Remedy::Kind::moreDamping);
        QCOMPARE(moreDamping != nullptr, isStable(squaredFrequency, 1.0, newDamp));
        if (moreDamping)
            QCOMPARE(moreDamping->value, newDamp);
    }

    void everyRemedyBringsTheRunToRest_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : {"published", "semi_implicit_euler", "velocity_verlet", "rk4"})
            QTest::newRow(method) << method;
    }
    void everyRemedyBringsTheRunToRest()
    {
        QFETCH(QString, method);
        const Script script = linearStar(60, method.toUtf8());
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        QVERIFY(findRemedy(found, Remedy::Kind::smallerStep));
        const Remedy *other = findRemedy(found, Remedy::Kind::unlimitedMethod);
        QVERIFY(other && other->method->stepLimit() == StepLimit::none);
        for (const Remedy &remedy : found) {
            Track track(withRemedy(script, remedy), 0);
            track.seek({5 * remedy.stableFrames, 0});
            QVERIFY(!track.stop());
            const State &end = track.state(); // with springs of length 0 all points rest at the same position
            for (int i = 0; i < end.pointCount(); ++i)
                QVERIFY(length(end.positionOf(i) - end.positionOf(0)) < 1e-6 &&
                        length(end.velocityOf(i)) < 1e-6);
        }
    }

    void remedyWithEndlessMotionIsNotSuggested()
    {
        // At a step of 1/32 these legs stay within some hundred px, but never come to rest.
        Script script = linearStar(3);
        script.build = [](const Values &values) {
            Scene scene = scenes::springCreature(3, 1000.0, 50.0);
            scenes::placeFeet(scene, {{322, 154}, {210, 170}, {265, 272}});
            scenes::add<Damping>(scene, values["damp"]);
            return scene;
        };
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        QVERIFY(findRemedy(found, Remedy::Kind::smallerStep));
        for (const Remedy &remedy : found) {
            Track track(withRemedy(script, remedy), 0);
            track.seek({2000, 0});
            QVERIFY(!track.stop());
            QVERIFY2(track.state().velocity.abs().maxCoeff() < 1e-3, remedy.method->id().c_str());
        }
    }

    void startPositionDoesNotMatter()
    {
        Script script = linearStar(1);
        script.build = [](const Values &values) {
            return scenes::oscillator({0, 0}, {270, 200}, values["k"], values["damp"]);
        };
        script.values.set("k", 20.0);
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        const Remedy *smaller = findRemedy(found, Remedy::Kind::smallerStep);
        QVERIFY(smaller && smaller->stableFrames > 0);
        QCOMPARE(smaller->step.h, 0.25); // k h^2 = 20 / 4 is beyond the limit, 20 / 16 is not
        QVERIFY(findRemedy(found, Remedy::Kind::unlimitedMethod));
    }

    void remedyChangesNothingElse()
    {
        Script script = linearStar(60);
        script.bodies["foot3"] = {{111, 222}, {}};
        script.effectsOff = {"wind"};
        script.input = {{3, Grab{"foot1"}}, {3, Move{{300, 310}}}, {9, Release{}}, {12, Set{"damp", 0.9}}};
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        for (const auto kind :
             {Remedy::Kind::smallerStep, Remedy::Kind::moreDamping, Remedy::Kind::unlimitedMethod})
            QVERIFY(findRemedy(found, kind));
        for (const Remedy &remedy : found) {
            const Script other = withRemedy(script, remedy);
            QVERIFY(other.bodies == script.bodies);
            QCOMPARE(other.effectsOff, script.effectsOff);
            QCOMPARE(other.values["k"], 0.2);
            const bool isDamped = remedy.kind == Remedy::Kind::moreDamping;
            QCOMPARE(other.values == script.values, !isDamped);
            QCOMPARE(other.input == script.input, !isDamped);
            QCOMPARE(other.input.size(), script.input.size());
            QCOMPARE(other.method->id() == script.method->id(), remedy.kind != Remedy::Kind::unlimitedMethod);
            QCOMPARE(other.step == script.step, remedy.kind != Remedy::Kind::smallerStep);
            if (isDamped) // the event's damping is stronger, too
                QVERIFY(std::get<Set>(other.input.back().what).value < 0.9);
        }
    }

    void runWithTooManyStepsGetsALargerTolerance()
    {
        support::Sample sample;
        sample.build = [](const Values &) {
            Scene scene = scenes::linearCreature(1, 8e6);
            scene.start.place(0, {300, 200});
            return scene;
        };
        Script script = support::script(sample, "dormand_prince");
        script.step = StepSize::withTolerance(1e-13);
        const Stop stop = stopOf(script);
        QVERIFY(stop.reason == StopReason::tooManySteps);
        const std::vector<Remedy> found = remediesAfter(script, stop, nullptr, neverCancel);
        const Remedy *larger = findRemedy(found, Remedy::Kind::largerTolerance);
        QVERIFY(larger && !findRemedy(found, Remedy::Kind::smallerStep) &&
                !findRemedy(found, Remedy::Kind::moreDamping));
        QVERIFY(findRemedy(found, Remedy::Kind::unlimitedMethod));
        // A tenth of the tolerance is not enough.
        const Script original = script;
        script.step = StepSize::withTolerance(larger->step.tolerance / 10.0);
        QVERIFY(stopOf(script).reason == StopReason::tooManySteps);
        Track track(withRemedy(original, *larger), 0);
        track.seek({larger->stableFrames + 20, 0});
        QVERIFY(!track.stop());
    }

    void methodThatDoesNotFitIsNotSuggested()
    {
        Script script = linearStar(60);
        const auto build = script.build;
        script.build = [build](const Values &values) {
            Scene scene = build(values);
            scene.effects.push_back(std::make_shared<Sticks>(std::vector<Stick>{{0, 1, 60.0}}, 61));
            return scene;
        };
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        QVERIFY(findRemedy(found, Remedy::Kind::smallerStep));
        QVERIFY(!findRemedy(found, Remedy::Kind::unlimitedMethod));
    }

    void onlyStableRemediesAreSuggested()
    {
        Script script = linearStar(60, "explicit_euler");
        // Neither a step of 1/64 nor full damping is enough.
        script.values.set("k", 1e9);
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found.front().kind == Remedy::Kind::unlimitedMethod);
    }

    void nothingIsSuggestedIfNothingIsStable()
    {
        Script script = linearStar(3); // a hand so fast that its velocity is not finite
        script.input = {{1, Grab{"foot1"}}, {1, Move{{1e308, 0.0}}}, {2, Move{{-1e308, 0.0}}}};
        const std::vector<Remedy> found = remediesAfter(script, stopOf(script), &dampRange, neverCancel);
        QVERIFY(found.empty());
    }

    void longTrialRunIsSkipped()
    {
        if (tests::isSanitized)
            QSKIP("Trials up to the limit of work take minutes with the sanitizers");
        Script script = linearStar(500);
        script.values.set("damp", 1.0); // a damped run would sleep, and then any length is quick
        Stop stop = stopOf(script);
        stop.frame = 1'000'000'000;
        const std::vector<Remedy> found = remediesAfter(script, stop, &dampRange, neverCancel);
        const Remedy *smaller = findRemedy(found, Remedy::Kind::smallerStep);
        QVERIFY(smaller);
        QCOMPARE(smaller->stableFrames, std::int64_t(0));
    }

    void cancelledSearchStopsSoon()
    {
        const Script script = linearStar(60);
        int calls = 0;
        const auto found = remediesAfter(script, stopOf(script), &dampRange, [&] { return ++calls < 50; });
        QVERIFY(found.empty());
        QVERIFY(calls < 60);
    }
};

SUITE(tst_trial_runs, TestTrialRuns)
#include "tst_trial_runs.moc"
