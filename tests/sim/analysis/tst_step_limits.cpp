// Stability limits predicted from Jacobians, against closed forms and against runs.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/stability_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace sim;
using namespace stability_scenes;

namespace {

/// Returns the smallest root of `f` above `from`, where `f` is negative. Searches in small steps, then
/// bisects.
double firstRoot(double from, const std::function<double(double)> &f)
{
    double low = from, high = from;
    while (f(high) < 0.0 && high < 1e3) {
        low = high;
        high *= 1.001;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return low;
}

struct NamedScene
{
    const char *name;
    OscillatingScene oscillating;
};

}

class TestStepLimits : public QObject
{
    Q_OBJECT

private slots:
    void limitsAgreeWithClosedForms_data();
    void limitsAgreeWithClosedForms();
    void limitsAgreeWithTheMeasuredOnset_data();
    void limitsAgreeWithTheMeasuredOnset();
    void scenesThatGrowAtEveryStepHaveTheLimitZero_data();
    void scenesThatGrowAtEveryStepHaveTheLimitZero();
    void selfPropellingPairIsBeyondItsLimit();
    void limitForManyFeetMatchesTheClosedForm_data();
    void limitForManyFeetMatchesTheClosedForm();
    void strongDampingMakesVeryLongStepsStable();
    void enoughDampingMakesEveryStepStable();
    void instabilityIsPredictedBeforeTheRunFails_data();
    void instabilityIsPredictedBeforeTheRunFails();
};

void TestStepLimits::limitsAgreeWithClosedForms_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<double>("limit");
    for (const double k : {1e-4, 0.2, 1.0, 1e6}) {
        const auto row = [&](const char *method, double damp, double limit) {
            QTest::addRow("%s, k %g, damp %g", method, k, damp) << QString(method) << k << damp << limit;
        };
        // Hairer, Lubich and Wanner, I.1 and I.5: the step's matrix has |trace| = 2 at omega h = 2.
        for (const char *method : {"semi_implicit_euler", "position_verlet", "velocity_verlet", "published"})
            row(method, 1.0, 2.0 / std::sqrt(k));
        // Hairer and Wanner II, IV.2: the end of the stability region on the imaginary axis.
        row("rk4", 1.0, 2.0 * std::sqrt(2.0) / std::sqrt(k));
        row("explicit_euler", 1.0, 0.0);
        row("midpoint", 1.0, 0.0);
        // With damping a step's matrix has the determinant d = e^(-c h). An eigenvalue leaves the unit circle
        // at -1, where the trace is -(1 + d). The trace is 1 + d - d k h^2 for semi-implicit Euler and 1 + d
        // - sqrt(d) k h^2 for both Verlet methods. For explicit Euler the limit is where the determinant d (1
        // + k h^2) is 1.
        const double damp = std::exp(-0.1 * std::sqrt(k)), c = -std::log(damp);
        const double from = 1e-6 / std::sqrt(k);
        const auto flip = [&](double power) {
            return firstRoot(from, [=](double h) {
                const double d = std::exp(-c * h);
                return std::pow(d, power) * k * h * h - 2.0 * (1.0 + d);
            });
        };
        row("semi_implicit_euler", damp, flip(1.0));
        row("published", damp, flip(1.0));
        row("position_verlet", damp, flip(0.5));
        row("velocity_verlet", damp, flip(0.5));
        row("explicit_euler", damp,
            firstRoot(from, [=](double h) { return std::exp(-c * h) * (1.0 + k * h * h) - 1.0; }));
    }
}

void TestStepLimits::limitsAgreeWithClosedForms()
{
    QFETCH(QString, method);
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(double, limit);
    const Stability found = predicted(onePoint(k, damp).scene, method.toStdString());
    QCOMPARE(found.bound, Bound::stiffness);
    // Limits are bisected to a relative error of 1e-4.
    QVERIFY2(std::abs(found.limit - limit) <= 2e-4 * limit,
             qPrintable(QString("%1, expected %2").arg(found.limit).arg(limit)));
    if (limit > 0.0) {
        QVERIFY(predicted(onePoint(k, damp).scene, method.toStdString(), 0.99 * limit).holds());
        QVERIFY(!predicted(onePoint(k, damp).scene, method.toStdString(), 1.01 * limit).holds());
    }
}

void TestStepLimits::limitsAgreeWithTheMeasuredOnset_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<OscillatingScene>("oscillating");
    const std::vector<NamedScene> scenes = {
        {"one damped point", onePoint(0.2, 0.9)}, {"chain", chain(5, 0.2, 1.0)},
        {"damped chain", chain(5, 0.2, 0.97)},    {"damped creature", creature(5, 0.2, 0.85)},
        {"creature", creature(4, 0.1, 1.0)},      {"damped bundle", bundle(7, 0.3, 0.9)},
        {"uneven masses and drags", uneven()},    {"damped tree", tree(0.05, 0.95)},
        {"soft pair", creature(1, 0.2, 0.9)},     {"twenty feet", manyFeet()},
    };
    int fitting = 0;
    for (const NamedScene &named : scenes) {
        for (const char *method : explicitMethods()) {
            const Stability found = predicted(named.oscillating.scene, method);
            if (found.limit > 0.0 && fitting++ % tests::sized(1, 3) == 0) // the next test covers limit 0
                QTest::addRow("%s, %s", named.name, method) << QString(method) << named.oscillating;
        }
    }
}

void TestStepLimits::limitsAgreeWithTheMeasuredOnset()
{
    QFETCH(QString, method);
    QFETCH(OscillatingScene, oscillating);
    const Stability found = predicted(oscillating.scene, method.toStdString());
    const double measured = onset(oscillating, method.toStdString(), 0.3 * found.limit);
    QVERIFY2(std::abs(found.limit - measured) <= 0.02 * measured,
             qPrintable(QString("%1 predicted, %2 measured").arg(found.limit).arg(measured)));
}

void TestStepLimits::scenesThatGrowAtEveryStepHaveTheLimitZero_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<OscillatingScene>("oscillating");
    for (const char *method : {"explicit_euler", "midpoint"}) {
        QTest::addRow("chain, %s", method) << QString(method) << chain(5, 0.2, 1.0);
        QTest::addRow("creature, %s", method) << QString(method) << creature(5, 0.2, 1.0);
    }
    // The method moves the feet before the body, so their forces do not add up to 0.
    QTest::addRow("pair, published") << QString("published") << creature(1, 0.2, 1.0);
    QTest::addRow("creature, published") << QString("published") << creature(5, 0.2, 1.0);
}

void TestStepLimits::scenesThatGrowAtEveryStepHaveTheLimitZero()
{
    QFETCH(QString, method);
    QFETCH(OscillatingScene, oscillating);
    const Stability found = predicted(oscillating.scene, method.toStdString(), 0.125);
    QCOMPARE(found.limit, 0.0);
    QVERIFY(std::isinf(found.share()));
    QVERIFY(!found.holds());
    for (const double h : {1.0, 0.5, 0.25})
        QVERIFY(grows(oscillating, method.toStdString(), h));
}

void TestStepLimits::selfPropellingPairIsBeyondItsLimit()
{
    // Both points move at velocity V. The spring is compressed by u when the foot moves, and by u - h V when
    // the body moves. So V (1 - d)/d is h k u for the foot and -h k (u - h V) for the body, which gives k h^2
    // = 2 (1 - d)/d, with d = damp^h.
    const double k = 0.3, damp = 0.9;
    const Stability found = predicted(creature(1, k, damp).scene, "published");
    const double limit =
        firstRoot(1e-3, [=](double h) { return k * h * h - 2.0 * (std::pow(damp, -h) - 1.0); });
    QVERIFY2(std::abs(found.limit - limit) < 2e-4 * limit, qPrintable(QString::number(found.limit)));
    QVERIFY(!found.holds());
    QCOMPARE(found.growthKind, GrowthKind::monotonic);
    QCOMPARE(found.dominant.point, 0);
    QCOMPARE(found.dominant.other, 1);
    // A momentum-conserving method and a softer pair are stable.
    QVERIFY(predicted(creature(1, k, damp).scene, "semi_implicit_euler").holds());
    QVERIFY(predicted(creature(1, 0.2, damp).scene, "published").holds());
    const auto speedAfter = [](const OscillatingScene &pair, const char *method) {
        Scene scene = pair.scene;
        scene.start.place(0, {330, 260});
        return length(support::plainRun(scene, method, 1.0, 3000).velocityOf(1));
    };
    QVERIFY(speedAfter(creature(1, k, damp), "published") > 1.0);
    QVERIFY(speedAfter(creature(1, 0.2, damp), "published") < 1e-6);
    QVERIFY(speedAfter(creature(1, k, damp), "semi_implicit_euler") < 1e-6);
}

void TestStepLimits::limitForManyFeetMatchesTheClosedForm_data()
{
    QTest::addColumn<int>("feet");
    for (const int feet : {1, 2, 5, 9})
        QTest::addRow("%d feet", feet) << feet;
}

void TestStepLimits::limitForManyFeetMatchesTheClosedForm()
{
    QFETCH(int, feet);
    // As for the pair, with `feet` forces on the body: k h^2 = (1 + feet)/feet (1 - d)/d.
    const double k = 0.2, damp = 0.85;
    const double limit = firstRoot(
        1e-3, [=](double h) { return k * h * h - (1.0 + feet) / feet * (std::pow(damp, -h) - 1.0); });
    const Stability found = predicted(bundle(feet, k, damp).scene, "published");
    QVERIFY2(std::abs(found.limit - limit) < 2e-4 * limit,
             qPrintable(QString("%1, expected %2").arg(found.limit).arg(limit)));
}

void TestStepLimits::strongDampingMakesVeryLongStepsStable()
{
    const OscillatingScene damped = onePoint(1.0, std::exp(-0.3));
    const Stability past = predicted(damped.scene, "semi_implicit_euler", 6.0);
    QVERIFY(past.limit > 2.0 && past.limit < 3.0);
    QVERIFY(!past.holds());
    QVERIFY(grows(damped, "semi_implicit_euler", 6.0));
    const Stability far = predicted(damped.scene, "semi_implicit_euler", 20.0);
    QCOMPARE(far.limit, past.limit);
    QVERIFY(far.holds());
    QVERIFY(!grows(damped, "semi_implicit_euler", 20.0));
}

void TestStepLimits::enoughDampingMakesEveryStepStable()
{
    // If c > 0.52 sqrt(k), then k h^2 < 2 (1 + e^(c h)) for all h. The curves k h^2 and 2 e^(c h) would touch
    // at h = 2/c.
    const Stability found = predicted(onePoint(0.2, 0.5).scene, "semi_implicit_euler", 7.0);
    QVERIFY(std::isinf(found.limit));
    QCOMPARE(found.share(), 0.0);
    QVERIFY(found.holds());
    const Stability stopped = predicted(onePoint(0.2, 0.0).scene, "semi_implicit_euler");
    QVERIFY(std::isinf(stopped.limit));
}

/// The rows are the hard cases that a method with a stability limit does not claim because the energy grows.
void TestStepLimits::instabilityIsPredictedBeforeTheRunFails_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("method");
    for (const HardCase &testCase : hardCases()) {
        if (testCase.id == "feet_10000")
            continue; // similar to feet_1000, but takes seconds
        for (const MethodPtr &method : allMethods()) {
            const Claim claim = claimOf(testCase, method, testCase.brief);
            const bool grows = claim.why && claim.why->id() == "claim-grows";
            if (grows && method->stepLimit() == StepLimit::stiffness)
                QTest::newRow((testCase.id + ", " + method->id()).c_str())
                    << QString::fromStdString(testCase.id) << QString::fromStdString(method->id());
        }
    }
}

void TestStepLimits::instabilityIsPredictedBeforeTheRunFails()
{
    QFETCH(QString, id);
    QFETCH(QString, method);
    const HardCase testCase = findHardCase(id.toStdString()).value();
    const MethodPtr rule = findMethod(method.toStdString());
    const Verdict verdict = judge(testCase, rule, testCase.brief);
    QVERIFY(!verdict.holds);
    // Predict at the start, or after the last parameter change.
    std::int64_t from = 0;
    for (const Event &event : testCase.script.input)
        from = std::max(from, std::holds_alternative<Set>(event.what) ? event.frame : 0);
    QVERIFY(from <= std::max(verdict.frames, std::int64_t(1)));
    Track track(scriptOf(testCase, rule, testCase.brief), 0);
    track.seek({from, 0});
    QVERIFY(!track.stop());
    const Stability prediction =
        stabilityOf(track.interval().scene, track.state(), *rule, track.script().step.h);
    QCOMPARE(prediction.bound, Bound::stiffness);
    QVERIFY2(prediction.share() > 1.0, qPrintable(QString::number(prediction.share())));
    QVERIFY(prediction.dominant.effect);
    const std::vector<Remedy> remedies =
        remediesFor(track.script(), track.interval().values, track.state(), prediction, nullptr);
    QVERIFY(!remedies.empty());
}

SUITE(tst_step_limits, TestStepLimits)
#include "tst_step_limits.moc"
