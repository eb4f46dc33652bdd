#include "lessons/api/checks/exact_run.h"
#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/lessons/attempts/attempts.h"
#include "tests/lessons/support/accuracy_truths.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace support;

class Accuracy : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("accuracy"));
    lessons::ExactRun m_exact;

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    sim::Script withTolerance(const char *id, double tolerance, const char *method = "dormand_prince") const
    {
        sim::Script script = step(id).script();
        script.method = sim::findMethod(method);
        script.step = sim::StepSize::withTolerance(tolerance);
        return script;
    }

    /// Returns the distance of the run from the exact run at `frame`, in px.
    double errorAt(const sim::Script &script, std::int64_t frame)
    {
        return m_exact.distance(script, stateAfter(script, frame), frame);
    }
    double errorAt(const char *id, const char *method, double h, std::int64_t frame)
    {
        return errorAt(scriptOf(step(id), method, h), frame);
    }

    /// Returns the values of the step's measure `number` at frames 0 to `frames`.
    std::vector<double> measured(const char *id, std::size_t number, const sim::Script &script,
                                 int frames) const
    {
        const lessons::Measure &measure = step(id).measures.at(number);
        sim::Track track(script, 0);
        std::vector<double> values;
        sim::State before;
        for (int frame = 0; frame <= frames; ++frame) {
            track.seek({frame, 0});
            values.push_back(measure.ofRun(script, track.interval().scene, track.state(),
                                           frame > 0 ? &before : nullptr, track.interval().values));
            before = track.state();
        }
        return values;
    }

    bool narrationContains(const char *id, const QString &text) const
    {
        return step(id).narration.contains(text);
    }

private slots:
    void bigStepErrorMatchesText();
    void explicitEulerEnergyGrowsAsTextSays_data();
    void explicitEulerEnergyGrowsAsTextSays();
    void energyOfOtherMethodsOscillatesAsTextSays();
    void dampingIsNotCountedAsDrift();
    void halvingTheStepReducesErrorsByOrder_data();
    void halvingTheStepReducesErrorsByOrder();
    void errorsAtEqualCostMatchText();
    void smallestErrorOfTheTextIsReadInTheWindow();
    void adaptiveStepsShortenOnlyNearTheCentre();
    void adaptiveStepsCostLess();
    void fixedStepThroughABounceHasOrderOne();
    void contactEventsKeepTheParabolas();
    void ballComesToRestInFiniteTime();
    void aFastRunOfTheSameCreatureMeetsTheBudget();
};

void Accuracy::bigStepErrorMatchesText()
{
    QVERIFY(narrationContains("big_step", u"once in 14.05 frames"_qs));
    QVERIFY(std::abs(2 * std::numbers::pi / std::sqrt(0.2) - 14.05) < 0.005);
    QVERIFY(narrationContains("big_step", u"after 100 frames it is 66 px off"_qs));
    const sim::Script script = step("big_step").script();
    const double error =
        std::abs(stateAfter(script, 100).positionOf(0).x - 270.0 - springDisplacement(130.0, 0.2, 100));
    QCOMPARE(std::round(error), 66.0);
    QVERIFY(std::abs(measured("big_step", 0, script, 100).back() - error) < 1e-6);
    QVERIFY(errorAt("big_step", "semi_implicit_euler", 0.125, 100) < 5.0);
    QVERIFY(errorAt(scriptOf(step("big_step"), "semi_implicit_euler", 1.0, {{"k", 0.02}}), 100) < 20.0);
}

void Accuracy::explicitEulerEnergyGrowsAsTextSays_data()
{
    QTest::addColumn<double>("h");
    for (double h : {1.0, 0.5, 0.125})
        QTest::addRow("h %g", h) << h;
}

/// In the plane of x and v / sqrt(k), a step rotates the state and multiplies its length by sqrt(1 + k h^2).
void Accuracy::explicitEulerEnergyGrowsAsTextSays()
{
    QFETCH(double, h);
    QVERIFY(narrationContains("energy", u"1 + k h²"_qs) &&
            narrationContains("energy", u"by 1.02. That doubles it every 35"_qs));
    const std::vector<double> drift =
        measured("energy", 0, scriptOf(step("energy"), "explicit_euler", h), 40);
    for (int frame = 0; frame <= 40; ++frame) {
        const double energy = std::pow(1 + 0.02 * h * h, frame / h);
        QVERIFY(std::abs(drift[static_cast<std::size_t>(frame)] - 100 * (energy - 1)) < 1e-5);
    }
    if (h == 1.0)
        QCOMPARE(std::round(drift[35]), 100.0);
}

void Accuracy::energyOfOtherMethodsOscillatesAsTextSays()
{
    QVERIFY(narrationContains("energy", u"swings 7 % round"_qs) &&
            narrationContains("energy", u"half a percent"_qs));
    const auto range = [&](const char *method) {
        const std::vector<double> drift = measured("energy", 0, scriptOf(step("energy"), method, 1.0), 1000);
        const auto [min, max] = std::minmax_element(drift.begin(), drift.end());
        return std::pair{*min, *max};
    };
    // k x^2 + v^2 - k h x v is conserved. So the energy lies between 1 / (1 + e) and 1 / (1 - e) of it,
    // with e = h sqrt(k) / 2 = 0.0707.
    const auto euler = range("semi_implicit_euler");
    QVERIFY(euler.first > -6.61 && euler.first < -6.4 && euler.second < 7.62 && euler.second > 7.3);
    // Velocity Verlet conserves k x^2 (1 - k h^2 / 4) + v^2.
    const auto verlet = range("velocity_verlet");
    QVERIFY(verlet.first > -0.501 && verlet.first < -0.49 && verlet.second < 1e-6);
}

void Accuracy::dampingIsNotCountedAsDrift()
{
    sim::Script script = withTolerance("energy", 1e-8);
    script.values.set("damp", 0.95);
    const std::vector<double> drift = measured("energy", 0, script, 60);
    QCOMPARE(drift.size(), std::size_t(61));
    for (double percent : drift)
        QVERIFY(std::abs(percent) < 1e-3);
    const sim::State end = stateAfter(script, 60); // the swing of 100 px has lost most of its energy
    QVERIFY(std::hypot(end.positionOf(0).x - 270.0, end.velocityOf(0).x / std::sqrt(0.02)) < 30.0);
}

void Accuracy::halvingTheStepReducesErrorsByOrder_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("gain");
    QTest::newRow("order 1") << "semi_implicit_euler" << 2.0;
    QTest::newRow("order 2") << "midpoint" << 4.0;
    QTest::newRow("order 4") << "rk4" << 16.0;
}

void Accuracy::halvingTheStepReducesErrorsByOrder()
{
    QFETCH(QString, method);
    QFETCH(double, gain);
    const std::string id = method.toStdString();
    const double before = errorAt("halve", id.c_str(), 1.0 / 8, 60);
    const double after = errorAt("halve", id.c_str(), 1.0 / 16, 60);
    QVERIFY2(std::abs(before / after / gain - 1.0) < 0.06, qPrintable(QString::number(before / after)));
}

void Accuracy::errorsAtEqualCostMatchText()
{
    QVERIFY(narrationContains("halve", u"the one is 0.13 px off at frame 60, and the other 0.44 px"_qs));
    QVERIFY(std::abs(errorAt("halve", "rk4", 1.0 / 2, 60) - 0.13) < 0.005);
    QVERIFY(std::abs(errorAt("halve", "semi_implicit_euler", 1.0 / 8, 60) - 0.44) < 0.005);
    QVERIFY(narrationContains("halve", u"it is 0.00003 px against 0.05"_qs));
    QVERIFY(std::abs(errorAt("halve", "rk4", 1.0 / 16, 60) - 0.00003) < 0.000005);
    QVERIFY(std::abs(errorAt("halve", "semi_implicit_euler", 1.0 / 64, 60) - 0.05) < 0.005);
    for (const auto &[method, h] : {std::pair{"rk4", 0.5}, std::pair{"semi_implicit_euler", 0.125}})
        QCOMPARE(measured("halve", 1, scriptOf(step("halve"), method, h), 3).back(), 8.0);
    QVERIFY(errorAt("halve", "rk4", 2.0, 60) > 30.0 &&
            errorAt("halve", "semi_implicit_euler", 2.0, 60) > 30.0);
}

void Accuracy::smallestErrorOfTheTextIsReadInTheWindow()
{
    QVERIFY(narrationContains("halve", u"is 0.00003 px against 0.05"_qs));
    QVERIFY(std::pow(10.0, -step("halve").measures.front().decimals) <= 0.00003);
}

void Accuracy::adaptiveStepsShortenOnlyNearTheCentre()
{
    QVERIFY(narrationContains("adapt", u"almost 4 frames far out, less than half a frame in the middle"_qs));
    const sim::Script script = step("adapt").script();
    QCOMPARE(script.step.tolerance, 1e-3);
    const std::vector<double> length = measured("adapt", 1, script, 150);
    double inside = 100.0, outside = 0.0;
    for (int frame = 1; frame <= 150; ++frame) {
        const double distance = sim::length(m_exact.at(script, frame)->positionOf(0) - sim::Vec2{270, 200});
        double &extreme = distance < 30.0 ? inside : outside;
        const double taken = length[static_cast<std::size_t>(frame)];
        extreme = distance < 30.0 ? std::min(inside, taken) : std::max(outside, taken);
        QVERIFY(distance < 30.0 || taken > 0.6);
    }
    QVERIFY(outside > 3.6 && outside < 4.0);
    QVERIFY(inside < 0.5);
}

void Accuracy::adaptiveStepsCostLess()
{
    const sim::Script script = step("adapt").script();
    const double error = errorAt(script, 150);
    QVERIFY(error > 0.001 && error < 0.2);
    const double perFrame = stateAfter(script, 150).forceEvaluations() / 150;
    QVERIFY(perFrame < 5.0);
    double sum = 0.0;
    for (double evaluations : measured("adapt", 2, script, 150))
        sum += std::isfinite(evaluations) ? evaluations : 0.0;
    QCOMPARE(sum, std::round(perFrame * 150));
    QVERIFY(errorAt("adapt", "rk4", 0.5, 150) > 0.2); // 8 evaluations per frame
    QVERIFY(errorAt("adapt", "rk4", 0.25, 150) < 0.2);
}

void Accuracy::fixedStepThroughABounceHasOrderOne()
{
    QVERIFY(narrationContains("bounce", u"after 30.66 frames"_qs));
    QVERIFY(std::abs(std::sqrt(2 * 235.0 / 0.5) - 30.66) < 0.005);
    // The error is zero before the first bounce. Then it depends on how far the step ends below the floor.
    QVERIFY(errorAt("bounce", "rk4", 1.0, 30) < 1e-9);
    QVERIFY(errorAt("bounce", "rk4", 1.0, 35) > 1.0);
    // From 1/8 to 1/128, the error of order 1 falls by about 16, with some scatter. Order 4 would give 16^4.
    const double gain = errorAt("bounce", "rk4", 1.0 / 8, 200) / errorAt("bounce", "rk4", 1.0 / 128, 200);
    QVERIFY2(gain > 4.0 && gain < 64.0, qPrintable(QString::number(gain)));
}

void Accuracy::contactEventsKeepTheParabolas()
{
    const sim::Script script = withTolerance("bounce", 1e-3);
    for (int frame : {31, 60, 92, 150, 200, 270}) {
        const double height = bouncingHeight(235.0, 0.5, 1.0, frame);
        QVERIFY(std::abs(365.0 - stateAfter(script, frame).positionOf(0).y - height) < 1e-7);
    }
    const std::vector<double> drift = measured("bounce", 1, script, 200);
    QVERIFY(std::abs(drift.back()) < 1e-6);
}

void Accuracy::ballComesToRestInFiniteTime()
{
    QVERIFY(narrationContains("bounce", u"Infinitely many fit into 92 frames"_qs));
    const double first = std::sqrt(2 * 235.0 / 0.5);
    QCOMPARE(std::round(first + 2 * first * 0.5 / (1 - 0.5)), 92.0);
    sim::Script script = withTolerance("bounce", 1e-3);
    script.values.set("bounce", 0.5);
    QVERIFY(!stateAfter(script, 70).restingContacts.any());
    const sim::State rest = stateAfter(script, 93);
    QVERIFY(rest.restingContacts.any());
    QVERIFY(std::abs(rest.positionOf(0).y - 365.0) < 1e-9);
    QCOMPARE(rest.velocityOf(0).y, 0.0);
}

void Accuracy::aFastRunOfTheSameCreatureMeetsTheBudget()
{
    const auto meetsBudget = [&](double nsPerFrame, bool isChanged) {
        RunPlayer player(step("budget"), 1);
        player.useTiming([=](const sim::Script &, std::int64_t) { return nsPerFrame; });
        player.useMethod("rk4");
        if (isChanged)
            player.set("k", 0.0);
        player.play(220);
        return player.done();
    };
    QVERIFY(meetsBudget(1.0, false));
    QVERIFY(!meetsBudget(600.0, false));
    QVERIFY(!meetsBudget(1.0, true));
}

SUITE(tst_accuracy, Accuracy)
#include "tst_accuracy.moc"
