// The error of sticks and its remedies, against the closed form of two sticks that hang one below the other.

#include "tests/sim/support/support.h"

#include "sim/analysis/stability/remedies/stick_fit.h"
#include "sim/catalogue/scenes.h"
#include "sim/methods/methods.h"
#include "sim/scenes/sticks.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace sim;

namespace {

const ShouldContinue neverCancel = [] { return true; };
const IterationRange iterationRange = {"passes", 1000.0};
constexpr double damp = 0.9;

/// Returns a fixed point and two points below it, each on a stick of 50 px.
Script twoSticks(double gravity, double h, int iterations)
{
    support::Sample sample;
    sample.values.set("gravity", gravity);
    sample.values.set("passes", iterations);
    sample.build = [](const Values &values) {
        return scenes::fallingSticks({.places = {{270.0, 100.0}, {270.0, 150.0}, {270.0, 200.0}},
                                      .sticks = scenes::chainOfSticks(2, 50.0),
                                      .pinned = {0},
                                      .gravity = values["gravity"],
                                      .damp = damp,
                                      .passes = values.integer("passes")});
    };
    Script script = support::script(sample, "semi_implicit_euler");
    script.step = StepSize::ofLength(h);
    return script;
}

/// Returns the error of the upper stick at rest, in px. In a step gravity moves each point by s = damp^h g
/// h^2. An iteration moves the upper point back, and then shares the remaining error between both points. So
/// each iteration halves the error d of the lower point, and (d + s) / 2^n = d after n iterations. At rest
/// the upper point has the same error d.
double errorAtRest(double gravity, double h, double iterations)
{
    return std::pow(damp, h) * gravity * h * h / (std::exp2(iterations) - 1.0);
}

const Remedy *find(const std::vector<Remedy> &all, Remedy::Kind kind)
{
    for (const Remedy &remedy : all) {
        if (remedy.kind == kind)
            return &remedy;
    }
    return nullptr;
}

}

class TestStickFit : public QObject
{
    Q_OBJECT

private slots:
    void theWorstStickIsFoundWithItsSign()
    {
        Scene scene = twoSticks(0.0, 1.0, 1).build(twoSticks(0.0, 1.0, 1).values);
        // The upper stick is 2 px too long, the lower one 7 px too short.
        scene.start.place(1, {270.0, 152.0});
        scene.start.place(2, {270.0, 195.0});
        const StickFit worst = worstStick(scene, scene.start);
        QCOMPARE(worst.error, -7.0);
        QCOMPARE(worst.length, 50.0);
        QCOMPARE(worst.a, 1);
        QCOMPARE(worst.b, 2);
        scene.start.place(2, {std::nan(""), 195.0});
        QVERIFY(std::isnan(worstStick(scene, scene.start).error));
    }

    void stickBetweenFixedPointsIsIgnored()
    {
        const Scene scene = hard::fixedStick(hard::valuesOf({{"damp", 0.9}, {"gravity", 0.0}}));
        // The stick between the fixed points is 50 px too long.
        const StickFit worst = worstStick(scene, scene.start);
        QCOMPARE(worst.error, 0.0);
        QCOMPARE(worst.b, 2);
    }

    void errorOfHangingSticksMatchesTheClosedForm_data()
    {
        QTest::addColumn<double>("gravity");
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("iterations");
        QTest::newRow("one iteration") << 8.0 << 1.0 << 1;
        QTest::newRow("three iterations") << 8.0 << 1.0 << 3;
        QTest::newRow("step of half a frame") << 8.0 << 0.5 << 1;
        QTest::newRow("step of an eighth, two iterations") << 30.0 << 0.125 << 2;
    }
    void errorOfHangingSticksMatchesTheClosedForm()
    {
        QFETCH(double, gravity);
        QFETCH(double, h);
        QFETCH(int, iterations);
        const std::optional<StickAdvice> advice =
            stickAdvice(twoSticks(gravity, h, iterations), 2000, nullptr, neverCancel);
        QVERIFY(advice);
        const double error = errorAtRest(gravity, h, iterations);
        QVERIFY2(std::abs(advice->now.error - error) < 1e-9 * error,
                 qPrintable(QString("%1, not %2").arg(advice->now.error).arg(error)));
    }

    void smallestSufficientChangeIsSuggested_data()
    {
        QTest::addColumn<double>("gravity");
        QTest::newRow("some gravity") << 8.0;
        QTest::newRow("more gravity") << 30.0;
        QTest::newRow("hardly too much gravity") << 0.7;
        QTest::newRow("strong gravity") << 200.0;
    }
    void smallestSufficientChangeIsSuggested()
    {
        QFETCH(double, gravity);
        const Script script = twoSticks(gravity, 1.0, 1);
        const std::optional<StickAdvice> advice = stickAdvice(script, 2000, &iterationRange, neverCancel);
        QVERIFY(advice);
        double h = 0.5;
        while (errorAtRest(gravity, h, 1) > fitting)
            h /= 2.0;
        const Remedy *smaller = find(advice->remedies, Remedy::Kind::smallerStep);
        QVERIFY(smaller);
        QCOMPARE(smaller->step.h, h);
        QVERIFY(std::abs(*smaller->stickError - errorAtRest(gravity, h, 1)) < 1e-9);
        double iterations = 2.0;
        while (errorAtRest(gravity, 1.0, iterations) > fitting)
            iterations *= 2.0;
        const Remedy *moreIterations = find(advice->remedies, Remedy::Kind::moreIterations);
        QVERIFY(moreIterations);
        QCOMPARE(moreIterations->parameter, std::string("passes"));
        QCOMPARE(moreIterations->value, iterations);
        QVERIFY(std::abs(*moreIterations->stickError - errorAtRest(gravity, 1.0, iterations)) < 1e-9);
    }

    void laterEventsWithFewerIterationsAreRaised()
    {
        Script script = twoSticks(8.0, 1.0, 4);
        script.input = {eventOf(100, Move{}), {100, Set{"passes", 1.0}}, {200, Set{"passes", 900.0}}};
        script.input.erase(script.input.begin());
        Remedy moreIterations = Remedy::of(Remedy::Kind::moreIterations, script.method, script.step);
        moreIterations.parameter = "passes";
        moreIterations.value = 8.0;
        const Script other = withRemedy(script, moreIterations);
        QCOMPARE(other.values["passes"], 8.0);
        QCOMPARE(std::get<Set>(other.input[0].what).value, 8.0);
        QCOMPARE(std::get<Set>(other.input[1].what).value, 900.0);
        QCOMPARE(other.method->id(), script.method->id());
    }

    void fittingSticksGetNoRemedy()
    {
        const std::optional<StickAdvice> advice =
            stickAdvice(twoSticks(0.5, 1.0, 1), 2000, &iterationRange, neverCancel);
        QVERIFY(advice && advice->remedies.empty());
        QVERIFY(advice->now.error > 0.0 && advice->now.error <= fitting);
    }

    void contradictorySticksGetNoRemedy()
    {
        Script script = twoSticks(0.0, 1.0, 10);
        script.build = hard::contradiction;
        script.values = hard::valuesOf({{"damp", 0.9}, {"passes", 10}});
        const std::optional<StickAdvice> advice = stickAdvice(script, 300, &iterationRange, neverCancel);
        QVERIFY(advice);
        QVERIFY(std::abs(advice->now.error) > 2.0); // 8 px are missing on three sticks
        QVERIFY(advice->remedies.empty());
    }

    void noAdviceWithoutSticksOrTime()
    {
        QVERIFY(!stickAdvice(support::script(support::sample("heavy pair"), "published"), 100,
                             &iterationRange, neverCancel));
        const Script script = twoSticks(8.0, 1.0, 1);
        // A trial run would take too long.
        QVERIFY(!stickAdvice(script, 1'000'000'000, &iterationRange, neverCancel));
        QVERIFY(!stickAdvice(script, 2000, &iterationRange, [] { return false; }));
    }
};

SUITE(tst_stick_fit, TestStickFit)
#include "tst_stick_fit.moc"
