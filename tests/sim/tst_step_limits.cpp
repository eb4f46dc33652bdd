// Where steps begin to fail: predicted from slopes, against closed forms and against runs.

#include "sim/run/script/composed_interval.h"
#include "stability_scenes.h"
#include "support.h"

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace sim;
using namespace stability_bench;

namespace {

/// The smallest root of `f`, which is below 0 just above `from`: looked for in small steps, then halved.
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

struct Named
{
    const char *name;
    Swinging swinging;
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
    void whatGrowsAtEveryStepHasTheLimitNought_data();
    void whatGrowsAtEveryStepHasTheLimitNought();
    void thePairThatPropelsItselfIsPastItsLimit();
    void manyFeetDriveTheirBodyByTheClosedForm_data();
    void manyFeetDriveTheirBodyByTheClosedForm();
    void strongDampingHoldsLongStepsAgain();
    void enoughDampingHoldsEveryStep();
    void whatCannotHoldIsSaidBeforeItFails_data();
    void whatCannotHoldIsSaidBeforeItFails();
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
        // Hairer, Lubich and Wanner, I.1 and I.5: |trace| of the step is 2 at omega h = 2.
        for (const char *method : {"semi_implicit_euler", "position_verlet", "velocity_verlet", "published"})
            row(method, 1.0, 2.0 / std::sqrt(k));
        // Hairer and Wanner II, IV.2: the end of the stability region on the imaginary axis.
        row("rk4", 1.0, 2.0 * std::sqrt(2.0) / std::sqrt(k));
        row("explicit_euler", 1.0, 0.0);
        row("midpoint", 1.0, 0.0);
        // With damping a step's matrix has the determinant d = e^(-c h). It leaves the unit circle at -1, where its
        // trace is -(1 + d): 1 + d - d k h^2 for semi-implicit Euler, 1 + d - sqrt(d) k h^2 for both of Verlet's; and
        // explicit Euler's, d (1 + k h^2), where that is 1.
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
    // Limits are halved down to 1e-4 of themselves.
    QVERIFY2(std::abs(found.limit - limit) <= 2e-4 * limit,
             qPrintable(QString("%1 in place of %2").arg(found.limit).arg(limit)));
    if (limit > 0.0) {
        QVERIFY(predicted(onePoint(k, damp).scene, method.toStdString(), 0.99 * limit).holds());
        QVERIFY(!predicted(onePoint(k, damp).scene, method.toStdString(), 1.01 * limit).holds());
    }
}

void TestStepLimits::limitsAgreeWithTheMeasuredOnset_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<Swinging>("swinging");
    const std::vector<Named> scenes = {
        {"one damped point", onePoint(0.2, 0.9)}, {"chain", chain(5, 0.2, 1.0)},
        {"damped chain", chain(5, 0.2, 0.97)},    {"damped creature", creature(5, 0.2, 0.85)},
        {"creature", creature(4, 0.1, 1.0)},      {"damped bundle", bundle(7, 0.3, 0.9)},
        {"uneven masses and drags", uneven()},    {"damped tree", tree(0.05, 0.95)},
        {"soft pair", creature(1, 0.2, 0.9)},     {"twenty feet", manyFeet()},
    };
    for (const Named &one : scenes) {
        for (const char *method : explicitMethods()) {
            const Stability found = predicted(one.swinging.scene, method);
            if (found.limit > 0.0) // the others: see the next test
                QTest::addRow("%s, %s", one.name, method) << QString(method) << one.swinging;
        }
    }
}

void TestStepLimits::limitsAgreeWithTheMeasuredOnset()
{
    QFETCH(QString, method);
    QFETCH(Swinging, swinging);
    const Stability found = predicted(swinging.scene, method.toStdString());
    const double measured = onset(swinging, method.toStdString(), 0.3 * found.limit);
    QVERIFY2(std::abs(found.limit - measured) <= 0.02 * measured,
             qPrintable(QString("%1 predicted, %2 measured").arg(found.limit).arg(measured)));
}

void TestStepLimits::whatGrowsAtEveryStepHasTheLimitNought_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<Swinging>("swinging");
    for (const char *method : {"explicit_euler", "midpoint"}) {
        QTest::addRow("chain, %s", method) << QString(method) << chain(5, 0.2, 1.0);
        QTest::addRow("creature, %s", method) << QString(method) << creature(5, 0.2, 1.0);
    }
    // Feet, then body: the sum of pulls is not nought in between.
    QTest::addRow("pair, published") << QString("published") << creature(1, 0.2, 1.0);
    QTest::addRow("creature, published") << QString("published") << creature(5, 0.2, 1.0);
}

void TestStepLimits::whatGrowsAtEveryStepHasTheLimitNought()
{
    QFETCH(QString, method);
    QFETCH(Swinging, swinging);
    const Stability found = predicted(swinging.scene, method.toStdString(), 0.125);
    QCOMPARE(found.limit, 0.0);
    QVERIFY(std::isinf(found.share()));
    QVERIFY(!found.holds());
    for (const double h : {1.0, 0.5, 0.25})
        QVERIFY(grows(swinging, method.toStdString(), h));
}

void TestStepLimits::thePairThatPropelsItselfIsPastItsLimit()
{
    // Both drift at V. The spring is short by u when the foot moves, and by u - h V when the body does, so that
    // V (1 - d)/d = h k u for the foot and -h k (u - h V) for the body: k h^2 = 2 (1 - d)/d, with d = damp^h.
    const double k = 0.3, damp = 0.9;
    const Stability found = predicted(creature(1, k, damp).scene, "published");
    const double limit =
        firstRoot(1e-3, [=](double h) { return k * h * h - 2.0 * (std::pow(damp, -h) - 1.0); });
    QVERIFY2(std::abs(found.limit - limit) < 2e-4 * limit, qPrintable(QString::number(found.limit)));
    QVERIFY(!found.holds());
    QCOMPARE(found.growthKind, GrowthKind::monotonic);
    QCOMPARE(found.dominant.point, 0);
    QCOMPARE(found.dominant.other, 1);
    // The same pair under a method that keeps momentum, and a softer pair, rest.
    QVERIFY(predicted(creature(1, k, damp).scene, "semi_implicit_euler").holds());
    QVERIFY(predicted(creature(1, 0.2, damp).scene, "published").holds());
    const auto speedAfter = [](const Swinging &pair, const char *method) {
        Scene scene = pair.scene;
        scene.start.place(0, {330, 260});
        return length(support::plainRun(scene, method, 1.0, 3000).velocityOf(1));
    };
    QVERIFY(speedAfter(creature(1, k, damp), "published") > 1.0);
    QVERIFY(speedAfter(creature(1, 0.2, damp), "published") < 1e-6);
    QVERIFY(speedAfter(creature(1, k, damp), "semi_implicit_euler") < 1e-6);
}

void TestStepLimits::manyFeetDriveTheirBodyByTheClosedForm_data()
{
    QTest::addColumn<int>("feet");
    for (const int feet : {1, 2, 5, 9})
        QTest::addRow("%d feet", feet) << feet;
}

void TestStepLimits::manyFeetDriveTheirBodyByTheClosedForm()
{
    QFETCH(int, feet);
    // As for the pair, with as many pulls on the body: k h^2 = (1 + feet)/feet (1 - d)/d.
    const double k = 0.2, damp = 0.85;
    const double limit = firstRoot(
        1e-3, [=](double h) { return k * h * h - (1.0 + feet) / feet * (std::pow(damp, -h) - 1.0); });
    const Stability found = predicted(bundle(feet, k, damp).scene, "published");
    QVERIFY2(std::abs(found.limit - limit) < 2e-4 * limit,
             qPrintable(QString("%1 in place of %2").arg(found.limit).arg(limit)));
}

void TestStepLimits::strongDampingHoldsLongStepsAgain()
{
    const Swinging one = onePoint(1.0, std::exp(-0.3));
    const Stability past = predicted(one.scene, "semi_implicit_euler", 6.0);
    QVERIFY(past.limit > 2.0 && past.limit < 3.0);
    QVERIFY(!past.holds());
    QVERIFY(grows(one, "semi_implicit_euler", 6.0));
    const Stability far = predicted(one.scene, "semi_implicit_euler", 20.0);
    QCOMPARE(far.limit, past.limit);
    QVERIFY(far.holds());
    QVERIFY(!grows(one, "semi_implicit_euler", 20.0));
}

void TestStepLimits::enoughDampingHoldsEveryStep()
{
    // k h^2 < 2 (1 + e^(c h)) for all h where c > 0.52 sqrt(k): where h^2 and 2 e^(c h) would touch, h is 2/c.
    const Stability found = predicted(onePoint(0.2, 0.5).scene, "semi_implicit_euler", 7.0);
    QVERIFY(std::isinf(found.limit));
    QCOMPARE(found.share(), 0.0);
    QVERIFY(found.holds());
    const Stability stopped = predicted(onePoint(0.2, 0.0).scene, "semi_implicit_euler");
    QVERIFY(std::isinf(stopped.limit));
}

/// Every hard case that a method with a limit does not claim because it grows.
void TestStepLimits::whatCannotHoldIsSaidBeforeItFails_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("method");
    for (const HardCase &one : hardCases()) {
        if (one.id == "feet_10000")
            continue; // as feet_1000, and it takes seconds
        for (const MethodPtr &method : allMethods()) {
            const Claim claim = claimOf(one, method, one.brief);
            const bool grows = claim.why && claim.why->id() == "claim-grows";
            if (grows && method->stepLimit() == StepLimit::stiffness)
                QTest::newRow((one.id + ", " + method->id()).c_str())
                    << QString::fromStdString(one.id) << QString::fromStdString(method->id());
        }
    }
}

void TestStepLimits::whatCannotHoldIsSaidBeforeItFails()
{
    QFETCH(QString, id);
    QFETCH(QString, method);
    const HardCase one = findHardCase(id.toStdString()).value();
    const MethodPtr rule = findMethod(method.toStdString());
    const Verdict verdict = judge(one, rule, one.brief);
    QVERIFY(!verdict.holds);
    // At the start; where what is too stiff comes only with an event, as soon as that is there.
    std::int64_t from = 0;
    for (const Event &event : one.script.input)
        from = std::max(from, std::holds_alternative<Set>(event.what) ? event.frame : 0);
    QVERIFY(from <= std::max(verdict.frames, std::int64_t(1)));
    Track track(scriptOf(one, rule, one.brief), 0);
    track.seek({from, 0});
    QVERIFY(!track.stop());
    const Stability said = stabilityOf(track.interval().scene, track.state(), *rule, track.script().step.h);
    QCOMPARE(said.bound, Bound::stiffness);
    QVERIFY2(said.share() > 1.0, qPrintable(QString::number(said.share())));
    QVERIFY(said.dominant.effect);
    const std::vector<Remedy> remedies =
        remediesFor(track.script(), track.interval().values, track.state(), said, nullptr);
    QVERIFY(!remedies.empty());
}

QTEST_APPLESS_MAIN(TestStepLimits)
#include "tst_step_limits.moc"
