// How wrong sticks are, and what makes them fit: against the closed form of two sticks that hang one below the other.

#include "support.h"

#include "sim/analysis/stability/remedies/stick_fit.h"
#include "sim/catalogue/scenes.h"
#include "sim/methods/methods.h"
#include "sim/scenes/sticks.h"

#include <QTest>

#include <cmath>

using namespace sim;

namespace {

const ShouldContinue patient = [] { return true; };
const IterationRange passes = {"passes", 1000.0};
constexpr double damp = 0.9;

/// A nail, and below it two points, each on a stick of 50 px.
Script twoSticks(double gravity, double h, int count)
{
    support::Sample sample;
    sample.values.set("gravity", gravity);
    sample.values.set("passes", count);
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

/// The error of the upper stick at rest. In a step gravity moves each point by s = damp^h g h^2. A pass takes the upper
/// point back to its place and then shares what is left between both, so that it halves how far the lower one hangs too
/// low: (d + s) / 2^n = d after n passes, and the upper one hangs as much too low.
double errorAtRest(double gravity, double h, double count)
{
    return std::pow(damp, h) * gravity * h * h / (std::exp2(count) - 1.0);
}

const Remedy *find(const std::vector<Remedy> &all, Remedy::Kind kind)
{
    for (const Remedy &one : all) {
        if (one.kind == kind)
            return &one;
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
        scene.start.place(1, {270.0, 152.0}); // 52 px and 48 px, and the third one makes it 7 too short
        scene.start.place(2, {270.0, 195.0});
        const StickFit worst = worstStick(scene, scene.start);
        QCOMPARE(worst.error, -7.0);
        QCOMPARE(worst.length, 50.0);
        QCOMPARE(worst.a, 1);
        QCOMPARE(worst.b, 2);
        scene.start.place(2, {std::nan(""), 195.0});
        QVERIFY(std::isnan(worstStick(scene, scene.start).error));
    }

    void whatStandsFastAtBothEndsIsNobodysFault()
    {
        const Scene scene = hard::fixedStick(hard::valuesOf({{"damp", 0.9}, {"gravity", 0.0}}));
        const StickFit worst =
            worstStick(scene, scene.start); // the stick between the nails is 50 px too long
        QCOMPARE(worst.error, 0.0);
        QCOMPARE(worst.b, 2);
    }

    void theErrorOfHangingSticksIsTheClosedForm_data()
    {
        QTest::addColumn<double>("gravity");
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("count");
        QTest::newRow("one pass") << 8.0 << 1.0 << 1;
        QTest::newRow("three passes") << 8.0 << 1.0 << 3;
        QTest::newRow("half a frame") << 8.0 << 0.5 << 1;
        QTest::newRow("an eighth, two passes") << 30.0 << 0.125 << 2;
    }
    void theErrorOfHangingSticksIsTheClosedForm()
    {
        QFETCH(double, gravity);
        QFETCH(double, h);
        QFETCH(int, count);
        const std::optional<StickAdvice> advice =
            adviseOnSticks(twoSticks(gravity, h, count), 2000, nullptr, patient);
        QVERIFY(advice);
        const double error = errorAtRest(gravity, h, count);
        QVERIFY2(std::abs(advice->now.error - error) < 1e-9 * error,
                 qPrintable(QString("%1, not %2").arg(advice->now.error).arg(error)));
    }

    void theMildestThatFitsIsOffered_data()
    {
        QTest::addColumn<double>("gravity");
        QTest::newRow("some weight") << 8.0;
        QTest::newRow("more") << 30.0;
        QTest::newRow("hardly too much") << 0.7;
        QTest::newRow("a lot") << 200.0;
    }
    void theMildestThatFitsIsOffered()
    {
        QFETCH(double, gravity);
        const Script script = twoSticks(gravity, 1.0, 1);
        const std::optional<StickAdvice> advice = adviseOnSticks(script, 2000, &passes, patient);
        QVERIFY(advice);
        double h = 0.5;
        while (errorAtRest(gravity, h, 1) > fitting)
            h /= 2.0;
        const Remedy *smaller = find(advice->remedies, Remedy::Kind::smallerStep);
        QVERIFY(smaller);
        QCOMPARE(smaller->step.h, h);
        QVERIFY(std::abs(*smaller->stickError - errorAtRest(gravity, h, 1)) < 1e-9);
        double count = 2.0;
        while (errorAtRest(gravity, 1.0, count) > fitting)
            count *= 2.0;
        const Remedy *more = find(advice->remedies, Remedy::Kind::moreIterations);
        QVERIFY(more);
        QCOMPARE(more->parameter, std::string("passes"));
        QCOMPARE(more->value, count);
        QVERIFY(std::abs(*more->stickError - errorAtRest(gravity, 1.0, count)) < 1e-9);
    }

    void whatWasSetOnTheWayToFewerPassesGetsMore()
    {
        Script script = twoSticks(8.0, 1.0, 4);
        script.input = {eventOf(100, Move{}), {100, Set{"passes", 1.0}}, {200, Set{"passes", 900.0}}};
        script.input.erase(script.input.begin());
        Remedy more = Remedy::of(Remedy::Kind::moreIterations, script.method, script.step);
        more.parameter = "passes";
        more.value = 8.0;
        const Script other = withRemedy(script, more);
        QCOMPARE(other.values["passes"], 8.0);
        QCOMPARE(std::get<Set>(other.input[0].what).value, 8.0);
        QCOMPARE(std::get<Set>(other.input[1].what).value, 900.0);
        QCOMPARE(other.method->id(), script.method->id());
    }

    void sticksThatFitNeedNothing()
    {
        const std::optional<StickAdvice> advice =
            adviseOnSticks(twoSticks(0.5, 1.0, 1), 2000, &passes, patient);
        QVERIFY(advice && advice->remedies.empty());
        QVERIFY(advice->now.error > 0.0 && advice->now.error <= fitting);
    }

    void sticksThatContradictEachOtherAreNotMended()
    {
        Script script = twoSticks(0.0, 1.0, 10);
        script.build = hard::contradiction;
        script.values = hard::valuesOf({{"damp", 0.9}, {"passes", 10}});
        const std::optional<StickAdvice> advice = adviseOnSticks(script, 300, &passes, patient);
        QVERIFY(advice);
        QVERIFY(std::abs(advice->now.error) > 2.0); // 8 px are missing, on three sticks
        QVERIFY(advice->remedies.empty());
    }

    void whereThereIsNothingToSayNothingIsSaid()
    {
        QVERIFY(!adviseOnSticks(support::script(support::sample("heavy pair"), "published"), 100, &passes,
                                patient));
        const Script script = twoSticks(8.0, 1.0, 1);
        QVERIFY(!adviseOnSticks(script, 1'000'000'000, &passes, patient)); // a trial would take too long
        QVERIFY(!adviseOnSticks(script, 2000, &passes, [] { return false; }));
    }
};

QTEST_GUILESS_MAIN(TestStickFit)
#include "tst_stick_fit.moc"
