// Hard cases that break careless methods. Each method keeps its claims, claims are neither too many nor too
// few, and the judge reports failures.

#include "tests/sim/support/support.h"
#include "tests/sizes.h"

#include "sim/base/error.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace sim;

namespace {

HardCase hardCase(const char *id)
{
    return findHardCase(id).value();
}

Verdict judged(const HardCase &testCase, const char *method)
{
    return judge(testCase, findMethod(method), testCase.brief);
}

QByteArray messageOf(const std::optional<Error> &why)
{
    return why ? QByteArray(why->what()) : QByteArray();
}

bool claims(const char *id, const char *method)
{
    const HardCase found = hardCase(id);
    return claimOf(found, findMethod(method), found.brief).isMade;
}

/// Returns a spring of stiffness `k` that is stretched by 100 px.
StiffestSpring stretchedSpring(double k, double damp)
{
    return {100.0, k, 1.0, 0.0, damp};
}

}

class TestHardCatalogue : public QObject
{
    Q_OBJECT

private slots:
    void catalogueHasAtLeastFortyCases();
    void knownHardCasesAreListed_data();
    void knownHardCasesAreListed();
    void casesAreComplete();
    void everyClaimHolds_data();
    void everyClaimHolds();
    void missingClaimsHaveAReason();
    void stabilityLimitIsPredicted_data();
    void stabilityLimitIsPredicted();
    void oneStepIsPredictedExactly();
    void implicitMethodsClaimAnyStiffness();
    void stickErrorIsNotClaimedForLongerSteps();
    void undampedStiffModeDoesNotClaimRest();
    void publishedMethodDoesNotClaimTheCentreOfMass();
    void publishedPairPropelsItself();
    void judgeReportsTheFailure_data();
    void judgeReportsTheFailure();
    void judgeCanBeCancelled();
    void cancelledRunIsNotABrokenClaim();
};

void TestHardCatalogue::catalogueHasAtLeastFortyCases()
{
    std::set<std::string> ids;
    for (const HardCase &listed : hardCases())
        ids.insert(listed.id);
    QVERIFY(ids.size() >= 40);
    QCOMPARE(ids.size(), hardCases().size());
    QVERIFY(!findHardCase("no_such_case"));
}

void TestHardCatalogue::knownHardCasesAreListed_data()
{
    QTest::addColumn<QStringList>("ids");
    const auto row = [](const char *name, const QStringList &ids) { QTest::newRow(name) << ids; };
    row("stiffness at the limit of a step",
        {"stiffness_below_limit", "stiffness_at_limit", "stiffness_above_limit"});
    row("stiffness far past it",
        {"stiffness_1e3", "stiffness_1e6", "stiffness_1e9", "stiffness_1e9_undamped", "stiffness_jumps"});
    row("full damping, no damping, and almost full damping", {"damp_0", "damp_1", "damp_1e-300"});
    row("many feet on one body", {"feet_60", "feet_100", "feet_1000", "feet_10000"});
    row("a pair that propels itself", {"runaway_pair"});
    row("coincident points", {"one_place", "on_one_line", "no_rest_length", "crowd_squeezed"});
    row("a drag that jumps", {"grabbed_one_frame", "dragged_1e9", "dragged_1e9_stiff", "thrown_into_corner"});
    row("no room", {"walls_closer_than_body"});
    row("very different masses", {"masses_1_to_1e9", "masses_1_to_1e9_stiff"});
    row("extreme forces and clocks", {"gravity_1e6", "gait_pi", "gait_1e6"});
    row("sticks that cannot all have their length",
        {"contradictory_triangle", "chain_stretched", "chain_heavy", "stick_without_length",
         "stick_between_nails"});
    row("codelings", {"tail_through_lead", "tail_in_lead", "target_1e9"});
    row("wind without direction or distance",
        {"wind_no_direction", "wind_no_distance", "wind_no_distance_published", "pointer_on_root"});
    row("trees", {"branches_16_deep", "tree_without_end", "tree_stiff"});
    row("steps", {"step_1e-6", "step_third", "step_100"});
    row("long runs", {"ten_million_frames", "million_frames_at_rest"});
    row("input that is not a number", {"hand_not_a_number", "pointer_infinite", "parameter_infinite"});
}

void TestHardCatalogue::knownHardCasesAreListed()
{
    QFETCH(QStringList, ids);
    for (const QString &id : ids)
        QVERIFY2(findHardCase(id.toStdString()), qPrintable(id));
}

void TestHardCatalogue::casesAreComplete()
{
    for (const HardCase &testCase : hardCases()) {
        const QByteArray id = testCase.id.c_str();
        QVERIFY2(!testCase.title.empty() && testCase.story.ends_with('.'), id);
        QVERIFY2(!testCase.requirements.empty(), id);
        QVERIFY2(testCase.brief.frames > 0 && testCase.brief.frames <= testCase.full.frames, id);
        QVERIFY2(testCase.hasRequirement(Requirement::rejected) == !testCase.expectedError.empty(), id);
        if (testCase.hasRequirement(Requirement::rejected))
            continue;
        QVERIFY2(testCase.bound.reach > 0.0, id);
        QVERIFY2(testCase.stiffest.has_value() || !testCase.hasRequirement(Requirement::oscillates), id);
        QVERIFY2(testCase.bound.drift.has_value() == testCase.hasRequirement(Requirement::centreStays), id);
        const Scene scene = testCase.script.build(testCase.script.values);
        if (!testCase.rest)
            continue;
        for (const RestPosition &position : testCase.rest->places)
            QVERIFY2(scene.find(position.body) >= 0, id);
        for (const RestDistance &distance : testCase.rest->distances)
            QVERIFY2(scene.find(distance.a) >= 0 && scene.find(distance.b) >= 0, id);
        for (int i = 0; i < testCase.rest->legs.feet; ++i)
            QVERIFY2(scene.find("foot" + std::to_string(i)) >= 0 && scene.find("body") >= 0, id);
    }
}

void TestHardCatalogue::everyClaimHolds_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("method");
    int made = 0;
    for (const HardCase &testCase : hardCases()) {
        for (const MethodPtr &method : allMethods()) {
            const bool isMade = claimOf(testCase, method, testCase.brief).isMade;
            if (isMade && made++ % tests::sized(1, 3) == 0) // a sample of all cases and methods
                QTest::newRow((testCase.id + ", " + method->id()).c_str())
                    << QString::fromStdString(testCase.id) << QString::fromStdString(method->id());
        }
    }
}

void TestHardCatalogue::everyClaimHolds()
{
    QFETCH(QString, id);
    QFETCH(QString, method);
    const HardCase testCase = findHardCase(id.toStdString()).value();
    const Verdict verdict = judge(testCase, findMethod(method.toStdString()), testCase.brief);
    QVERIFY2(verdict.holds, messageOf(verdict.why));
    QVERIFY(!verdict.isBroken());
    const bool mayEndEarly =
        testCase.hasRequirement(Requirement::rejected) || testCase.hasRequirement(Requirement::overflows);
    QVERIFY(mayEndEarly || verdict.frames == testCase.brief.frames);
}

void TestHardCatalogue::missingClaimsHaveAReason()
{
    for (const HardCase &testCase : hardCases()) {
        for (const MethodPtr &method : allMethods()) {
            const Claim claim = claimOf(testCase, method, testCase.brief);
            QVERIFY2(claim.isMade == !claim.why, (testCase.id + ", " + method->id()).c_str());
        }
    }
}

void TestHardCatalogue::stabilityLimitIsPredicted_data()
{
    // Without damping. For the first four see Hairer, Lubich and Wanner, "Geometric numerical integration",
    // section I.5. For the last, the polynomial 1 + z + z^2/2 + z^3/6 + z^4/24 leaves the unit circle at 2
    // sqrt 2 on the imaginary axis.
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("limit");
    QTest::newRow("published") << "published" << 4.0;
    QTest::newRow("semi-implicit Euler") << "semi_implicit_euler" << 4.0;
    QTest::newRow("position Verlet") << "position_verlet" << 4.0;
    QTest::newRow("velocity Verlet") << "velocity_verlet" << 4.0;
    QTest::newRow("Runge-Kutta 4") << "rk4" << 8.0;
}

void TestHardCatalogue::stabilityLimitIsPredicted()
{
    QFETCH(QString, method);
    QFETCH(double, limit);
    const MethodPtr rule = findMethod(method.toStdString());
    for (const double h : {1.0, 0.25}) {
        const double k = limit / (h * h);
        QVERIFY(predictOscillation(stretchedSpring(0.99 * k, 1.0), rule, h, 10'000, 1e9).most < 2000.0);
        QVERIFY(predictOscillation(stretchedSpring(1.01 * k, 1.0), rule, h, 10'000, 1e9).most > 1e9);
    }
}

void TestHardCatalogue::oneStepIsPredictedExactly()
{
    const double k = 3.0, damp = 0.5, x = 100.0;
    // v = damp (v - k x), x = x + v
    const Prediction explicitStep =
        predictOscillation(stretchedSpring(k, damp), findMethod("semi_implicit_euler"), 1.0, 1, 1e9);
    QCOMPARE(explicitStep.left, std::abs(x - damp * k * x));
    // v = damp (v - k (x + v))
    const Prediction implicitStep =
        predictOscillation(stretchedSpring(k, damp), findMethod("backward_euler"), 1.0, 1, 1e9);
    QCOMPARE(implicitStep.left, x - damp * k * x / (1.0 + damp * k));
    // With two free ends of mass 1 the distance oscillates like a single point of mass 1/2.
    const Prediction pair =
        predictOscillation({x, k, 1.0, 1.0, damp}, findMethod("semi_implicit_euler"), 1.0, 1, 1e9);
    QCOMPARE(pair.left, std::abs(x - damp * 2.0 * k * x));
}

void TestHardCatalogue::implicitMethodsClaimAnyStiffness()
{
    for (const char *method : {"backward_euler", "tr_bdf2"}) {
        for (const char *id : {"stiffness_1e3", "stiffness_1e6", "stiffness_1e9", "stiffness_1e9_undamped",
                               "stiffness_jumps", "masses_1_to_1e9_stiff", "dragged_1e9", "dragged_1e9_stiff",
                               "thrown_into_corner", "gravity_1e6", "feet_1000", "feet_10000", "step_100"})
            QVERIFY2(claims(id, method), id);
    }
    for (const char *id : {"stiffness_1e3", "stiffness_1e6", "stiffness_1e9"}) {
        for (const char *method : {"published", "semi_implicit_euler", "velocity_verlet", "rk4"})
            QVERIFY2(!claims(id, method), id);
    }
}

void TestHardCatalogue::stickErrorIsNotClaimedForLongerSteps()
{
    const HardCase chain = hardCase("chain_heavy_small_steps");
    const MethodPtr method = findMethod("semi_implicit_euler");
    QVERIFY(claimOf(chain, method, chain.brief).isMade);
    RunSize size = chain.brief;
    size.h = 1.0;
    const Claim claim = claimOf(chain, method, size);
    QVERIFY(!claim.isMade);
    QCOMPARE(claim.why->id(), std::string("claim-longer-step"));
    QVERIFY(!judge(chain, method, size).holds);
}

void TestHardCatalogue::undampedStiffModeDoesNotClaimRest()
{
    // At k h^2 = 1e9 a step of implicit midpoint reverses x and v, so damping has almost no effect.
    QVERIFY(claims("stiffness_1e9_undamped", "implicit_midpoint"));
    QVERIFY(!claims("stiffness_1e9", "implicit_midpoint"));
    QVERIFY(!judged(hardCase("stiffness_1e9"), "implicit_midpoint").holds);
    const Prediction predicted =
        predictOscillation(stretchedSpring(1e9, 0.9), findMethod("implicit_midpoint"), 1.0, 1001, 1e9);
    QVERIFY(predicted.left > 99.0 && predicted.most < 101.0);
}

void TestHardCatalogue::publishedMethodDoesNotClaimTheCentreOfMass()
{
    const HardCase pair = hardCase("runaway_pair");
    const Claim claim = claimOf(pair, findMethod("published"), pair.brief);
    QVERIFY(!claim.isMade);
    QCOMPARE(claim.why->id(), std::string("claim-one-by-one"));
    QVERIFY(claims("runaway_pair", "semi_implicit_euler"));
}

void TestHardCatalogue::publishedPairPropelsItself()
{
    const Verdict verdict = judged(hardCase("runaway_pair"), "published");
    QVERIFY(!verdict.holds);
    QCOMPARE(verdict.why->id(), std::string("hard-drifts"));
}

void TestHardCatalogue::judgeReportsTheFailure_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("why");
    const auto add = [](const char *title, const char *id, const char *method, const char *why) {
        QTest::newRow(title) << id << method << why;
    };
    add("too far", "stiffness_above_limit", "semi_implicit_euler", "hard-too-far");
    add("too many steps", "stiffness_1e9", "dormand_prince", "hard-too-many-steps");
    add("does not fit", "chain_stretched", "backward_euler", "method-does-not-fit");
    add("still moving", "stiffness_1e6", "implicit_midpoint", "hard-moves");
}

void TestHardCatalogue::judgeReportsTheFailure()
{
    QFETCH(QString, id);
    QFETCH(QString, method);
    QFETCH(QString, why);
    const Verdict verdict = judged(findHardCase(id.toStdString()).value(), qPrintable(method));
    QVERIFY(!verdict.holds);
    QVERIFY(!verdict.claim.isMade);
    QCOMPARE(QString::fromStdString(verdict.why->id()), why);
}

void TestHardCatalogue::judgeCanBeCancelled()
{
    const HardCase testCase = hardCase("ten_million_frames");
    int calls = 0;
    const Verdict verdict = judge(testCase, findMethod("semi_implicit_euler"), testCase.full,
                                  [&](double) { return ++calls < 2; });
    QCOMPARE(calls, 2);
    QVERIFY(!verdict.isComplete);
    QVERIFY(verdict.frames < testCase.full.frames);
}

void TestHardCatalogue::cancelledRunIsNotABrokenClaim()
{
    const HardCase testCase = hardCase("damp_1");
    const Verdict verdict =
        judge(testCase, findMethod("semi_implicit_euler"), testCase.brief, [](double) { return false; });
    QVERIFY(verdict.claim.isMade);
    QVERIFY(!verdict.holds);
    QVERIFY(!verdict.isBroken());
}

SUITE(tst_hard_catalogue, TestHardCatalogue)
#include "tst_hard_catalogue.moc"
