// What breaks careless methods: that each method holds what it claims, that claims are neither too many nor too few, and
// that the judge sees what fails.

#include "support.h"
#include "tests/sizes.h"

#include "sim/base/error.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace sim;

namespace {

HardCase hard(const char *id)
{
    return findHardCase(id).value();
}

Verdict judged(const HardCase &one, const char *method)
{
    return judge(one, findMethod(method), one.brief);
}

QByteArray whyOf(const std::optional<Error> &why)
{
    return why ? QByteArray(why->what()) : QByteArray();
}

bool claims(const char *id, const char *method)
{
    const HardCase one = hard(id);
    return claimOf(one, findMethod(method), one.brief).isMade;
}

/// A foot on a spring of stiffness `k`, 100 px out of its length.
StiffestSpring spring(double k, double damp)
{
    return {100.0, k, 1.0, 0.0, damp};
}

}

class TestHardCases : public QObject
{
    Q_OBJECT

private slots:
    void theCatalogueHasFortyCasesAndMore();
    void whatIsKnownToBreakIsThere_data();
    void whatIsKnownToBreakIsThere();
    void aCaseSaysWhatItIsAbout();
    void everyClaimHolds_data();
    void everyClaimHolds();
    void whatIsNotClaimedSaysWhy();
    void theLimitOfAStepIsForetold_data();
    void theLimitOfAStepIsForetold();
    void oneStepIsForetoldToTheDigit();
    void implicitMethodsClaimAnyStiffness();
    void aBoundOfSticksIsClaimedForNoLongerStep();
    void whatOnlyTurnsRoundDoesNotClaimRest();
    void whatMovesOneByOneDoesNotClaimTheMiddle();
    void thePublishedPairDrivesItselfOn();
    void theJudgeSeesWhatFails_data();
    void theJudgeSeesWhatFails();
    void whoLooksOnCanStopTheJudge();
    void aRunThatIsNotWantedIsNoBrokenClaim();
};

void TestHardCases::theCatalogueHasFortyCasesAndMore()
{
    std::set<std::string> ids;
    for (const HardCase &one : hardCases())
        ids.insert(one.id);
    QVERIFY(ids.size() >= 40);
    QCOMPARE(ids.size(), hardCases().size());
    QVERIFY(!findHardCase("no_such_case"));
}

void TestHardCases::whatIsKnownToBreakIsThere_data()
{
    QTest::addColumn<QStringList>("ids");
    const auto row = [](const char *what, const QStringList &ids) { QTest::newRow(what) << ids; };
    row("stiffness at the limit of a step",
        {"stiffness_below_limit", "stiffness_at_limit", "stiffness_above_limit"});
    row("stiffness far past it",
        {"stiffness_1e3", "stiffness_1e6", "stiffness_1e9", "stiffness_1e9_undamped", "stiffness_jumps"});
    row("all damping, none, and next to all", {"damp_0", "damp_1", "damp_1e-300"});
    row("many feet on one body", {"feet_60", "feet_100", "feet_1000", "feet_10000"});
    row("a pair that drives itself on", {"runaway_pair"});
    row("points without a direction between them",
        {"one_place", "on_one_line", "no_rest_length", "crowd_squeezed"});
    row("a hand that jumps", {"grabbed_one_frame", "dragged_1e9", "dragged_1e9_stiff", "thrown_into_corner"});
    row("no room", {"walls_closer_than_body"});
    row("masses apart", {"masses_1_to_1e9", "masses_1_to_1e9_stiff"});
    row("pulls and clocks out of all measure", {"gravity_1e6", "gait_pi", "gait_1e6"});
    row("sticks that cannot be right", {"contradictory_triangle", "chain_stretched", "chain_heavy",
                                        "stick_without_length", "stick_between_nails"});
    row("codelings", {"tail_through_lead", "tail_in_lead", "target_1e9"});
    row("wind without direction or distance",
        {"wind_no_direction", "wind_no_distance", "wind_no_distance_published", "pointer_on_root"});
    row("trees", {"branches_16_deep", "tree_without_end", "tree_stiff"});
    row("steps", {"step_1e-6", "step_third", "step_100"});
    row("long runs", {"ten_million_frames", "million_frames_at_rest"});
    row("input that is no number", {"hand_not_a_number", "pointer_infinite", "parameter_infinite"});
}

void TestHardCases::whatIsKnownToBreakIsThere()
{
    QFETCH(QStringList, ids);
    for (const QString &id : ids)
        QVERIFY2(findHardCase(id.toStdString()), qPrintable(id));
}

void TestHardCases::aCaseSaysWhatItIsAbout()
{
    for (const HardCase &one : hardCases()) {
        const QByteArray id = one.id.c_str();
        QVERIFY2(!one.title.empty() && one.story.ends_with('.'), id);
        QVERIFY2(!one.requirements.empty(), id);
        QVERIFY2(one.brief.frames > 0 && one.brief.frames <= one.full.frames, id);
        QVERIFY2(one.hasRequirement(Requirement::refused) == !one.refusal.empty(), id);
        if (one.hasRequirement(Requirement::refused))
            continue;
        QVERIFY2(one.bound.reach > 0.0, id);
        QVERIFY2(one.stiffest.has_value() || !one.hasRequirement(Requirement::oscillates), id);
        QVERIFY2(one.bound.drift.has_value() == one.hasRequirement(Requirement::centreStays), id);
        const Scene scene = one.script.build(one.script.values);
        if (!one.rest)
            continue;
        for (const RestPosition &place : one.rest->places)
            QVERIFY2(scene.find(place.body) >= 0, id);
        for (const RestDistance &distance : one.rest->distances)
            QVERIFY2(scene.find(distance.a) >= 0 && scene.find(distance.b) >= 0, id);
    }
}

void TestHardCases::everyClaimHolds_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("method");
    int made = 0;
    for (const HardCase &one : hardCases()) {
        for (const MethodPtr &method : allMethods()) {
            const bool isMade = claimOf(one, method, one.brief).isMade;
            if (isMade && made++ % tests::sized(1, 3) == 0) // in turn: some of each case, and of each method
                QTest::newRow((one.id + ", " + method->id()).c_str())
                    << QString::fromStdString(one.id) << QString::fromStdString(method->id());
        }
    }
}

void TestHardCases::everyClaimHolds()
{
    QFETCH(QString, id);
    QFETCH(QString, method);
    const HardCase one = findHardCase(id.toStdString()).value();
    const Verdict verdict = judge(one, findMethod(method.toStdString()), one.brief);
    QVERIFY2(verdict.holds, whyOf(verdict.why));
    QVERIFY(!verdict.isBroken());
    const bool isWhole =
        one.hasRequirement(Requirement::refused) || one.hasRequirement(Requirement::overflows);
    QVERIFY(isWhole || verdict.frames == one.brief.frames);
}

void TestHardCases::whatIsNotClaimedSaysWhy()
{
    for (const HardCase &one : hardCases()) {
        for (const MethodPtr &method : allMethods()) {
            const Claim claim = claimOf(one, method, one.brief);
            QVERIFY2(claim.isMade == !claim.why, (one.id + ", " + method->id()).c_str());
        }
    }
}

void TestHardCases::theLimitOfAStepIsForetold_data()
{
    // Where nothing damps: Hairer, Lubich and Wanner, "Geometric numerical integration", section I.5, for the first
    // four; the last is where the polynomial 1 + z + z^2/2 + z^3/6 + z^4/24 leaves the unit circle along the imaginary
    // axis, at 2 sqrt 2.
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("limit");
    QTest::newRow("published") << "published" << 4.0;
    QTest::newRow("semi-implicit Euler") << "semi_implicit_euler" << 4.0;
    QTest::newRow("position Verlet") << "position_verlet" << 4.0;
    QTest::newRow("velocity Verlet") << "velocity_verlet" << 4.0;
    QTest::newRow("Runge-Kutta 4") << "rk4" << 8.0;
}

void TestHardCases::theLimitOfAStepIsForetold()
{
    QFETCH(QString, method);
    QFETCH(double, limit);
    const MethodPtr rule = findMethod(method.toStdString());
    for (const double h : {1.0, 0.25}) {
        const double k = limit / (h * h);
        QVERIFY(predictOscillation(spring(0.99 * k, 1.0), rule, h, 10'000, 1e9).most < 2000.0);
        QVERIFY(predictOscillation(spring(1.01 * k, 1.0), rule, h, 10'000, 1e9).most > 1e9);
    }
}

void TestHardCases::oneStepIsForetoldToTheDigit()
{
    const double k = 3.0, damp = 0.5, x = 100.0;
    // v = damp (v - k x), x = x + v
    const Prediction plain =
        predictOscillation(spring(k, damp), findMethod("semi_implicit_euler"), 1.0, 1, 1e9);
    QCOMPARE(plain.left, std::abs(x - damp * k * x));
    // v = damp (v - k (x + v))
    const Prediction implicit =
        predictOscillation(spring(k, damp), findMethod("backward_euler"), 1.0, 1, 1e9);
    QCOMPARE(implicit.left, x - damp * k * x / (1.0 + damp * k));
    // Two free ends: their distance swings as if the one were twice as light.
    const Prediction pair =
        predictOscillation({x, k, 1.0, 1.0, damp}, findMethod("semi_implicit_euler"), 1.0, 1, 1e9);
    QCOMPARE(pair.left, std::abs(x - damp * 2.0 * k * x));
}

void TestHardCases::implicitMethodsClaimAnyStiffness()
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

void TestHardCases::aBoundOfSticksIsClaimedForNoLongerStep()
{
    const HardCase chain = hard("chain_heavy_small_steps");
    const MethodPtr method = findMethod("semi_implicit_euler");
    QVERIFY(claimOf(chain, method, chain.brief).isMade);
    RunSize size = chain.brief;
    size.h = 1.0;
    const Claim claim = claimOf(chain, method, size);
    QVERIFY(!claim.isMade);
    QCOMPARE(claim.why->id(), std::string("claim-longer-step"));
    QVERIFY(!judge(chain, method, size).holds); // and rightly so
}

void TestHardCases::whatOnlyTurnsRoundDoesNotClaimRest()
{
    // At k h^2 = 1e9 implicit midpoint takes x to -x, and the velocity with it: there is nothing to damp.
    QVERIFY(claims("stiffness_1e9_undamped", "implicit_midpoint"));
    QVERIFY(!claims("stiffness_1e9", "implicit_midpoint"));
    QVERIFY(!judged(hard("stiffness_1e9"), "implicit_midpoint").holds);
    const Prediction told =
        predictOscillation(spring(1e9, 0.9), findMethod("implicit_midpoint"), 1.0, 1001, 1e9);
    QVERIFY(told.left > 99.0 && told.most < 101.0);
}

void TestHardCases::whatMovesOneByOneDoesNotClaimTheMiddle()
{
    const HardCase pair = hard("runaway_pair");
    const Claim claim = claimOf(pair, findMethod("published"), pair.brief);
    QVERIFY(!claim.isMade);
    QCOMPARE(claim.why->id(), std::string("claim-one-by-one"));
    QVERIFY(claims("runaway_pair", "semi_implicit_euler"));
}

void TestHardCases::thePublishedPairDrivesItselfOn()
{
    const Verdict verdict = judged(hard("runaway_pair"), "published");
    QVERIFY(!verdict.holds);
    QCOMPARE(verdict.why->id(), std::string("hard-drifts"));
}

void TestHardCases::theJudgeSeesWhatFails_data()
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

void TestHardCases::theJudgeSeesWhatFails()
{
    QFETCH(QString, id);
    QFETCH(QString, method);
    QFETCH(QString, why);
    const Verdict verdict = judged(findHardCase(id.toStdString()).value(), qPrintable(method));
    QVERIFY(!verdict.holds);
    QVERIFY(!verdict.claim.isMade);
    QCOMPARE(QString::fromStdString(verdict.why->id()), why);
}

void TestHardCases::whoLooksOnCanStopTheJudge()
{
    const HardCase one = hard("ten_million_frames");
    int asked = 0;
    const Verdict verdict =
        judge(one, findMethod("semi_implicit_euler"), one.full, [&](double) { return ++asked < 2; });
    QCOMPARE(asked, 2);
    QVERIFY(!verdict.isComplete);
    QVERIFY(verdict.frames < one.full.frames);
}

void TestHardCases::aRunThatIsNotWantedIsNoBrokenClaim()
{
    const HardCase one = hard("damp_1");
    const Verdict verdict =
        judge(one, findMethod("semi_implicit_euler"), one.brief, [](double) { return false; });
    QVERIFY(verdict.claim.isMade);
    QVERIFY(!verdict.holds);
    QVERIFY(!verdict.isBroken());
}

QTEST_GUILESS_MAIN(TestHardCases)
#include "tst_hard_catalogue.moc"
