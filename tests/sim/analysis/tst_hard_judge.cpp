// Each check of the judge finds a failure that is caused on purpose.

#include "sim/base/error.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

/// Returns the id of the failure of a passing case after `change` is applied.
template <class Change>
std::string failureAfter(const char *id, Change &&change)
{
    HardCase testCase = findHardCase(id).value();
    const MethodPtr method = findMethod("semi_implicit_euler");
    if (!judge(testCase, method, testCase.brief).holds)
        return "it fails unchanged";
    change(testCase);
    const Verdict verdict = judge(testCase, method, testCase.brief);
    return verdict.holds ? "it passes" : verdict.why->id();
}

}

class TestHardJudge : public QObject
{
    Q_OBJECT

private slots:
    void tooTightBoundIsFound();
    void movedCentreOfMassIsFound();
    void wrongRestPositionIsFound();
    void wrongRestLengthIsFound();
    void remainingMotionIsFound();
    void stickErrorIsFound();
    void missingRefusalIsFound();
    void missingEndIsFound();
    void restIsRequiredOnlyAfterItsFrame();
};

void TestHardJudge::tooTightBoundIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.bound.reach = 99.0; };
    QCOMPARE(failureAfter("damp_1", change), std::string("hard-too-far"));
}

void TestHardJudge::movedCentreOfMassIsFound()
{
    const auto change = [](HardCase &testCase) {
        testCase.script.input = {{5, Grab{"body"}}, {6, Move{{280.0, 200.0}}}, {7, Release{}}};
    };
    QCOMPARE(failureAfter("runaway_pair", change), std::string("hard-drifts"));
}

void TestHardJudge::wrongRestPositionIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.rest->places.front().x.x += 1e-3; };
    QCOMPARE(failureAfter("step_third", change), std::string("hard-elsewhere"));
}

void TestHardJudge::wrongRestLengthIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.rest->legs.length += 1e-3; };
    QCOMPARE(failureAfter("runaway_pair", change), std::string("hard-length"));
}

void TestHardJudge::remainingMotionIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.script.values.set("damp", 1.0); };
    QCOMPARE(failureAfter("runaway_pair", change), std::string("hard-moves"));
}

void TestHardJudge::stickErrorIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.stickError = 1.0; };
    QCOMPARE(failureAfter("contradictory_triangle", change), std::string("hard-stick"));
}

void TestHardJudge::missingRefusalIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.script.input = {}; };
    QCOMPARE(failureAfter("hand_not_a_number", change), std::string("hard-not-refused"));
}

void TestHardJudge::missingEndIsFound()
{
    const auto change = [](HardCase &testCase) { testCase.script.input = {}; };
    QCOMPARE(failureAfter("wind_no_distance_published", change), std::string("hard-does-not-end"));
}

void TestHardJudge::restIsRequiredOnlyAfterItsFrame()
{
    HardCase testCase = findHardCase("step_third").value();
    const MethodPtr method = findMethod("semi_implicit_euler");
    RunSize size = testCase.brief;
    size.frames = 30; // far from rest
    QVERIFY(judge(testCase, method, size).holds);
    testCase.rest->after = 30;
    QVERIFY(!judge(testCase, method, size).holds);
}

SUITE(tst_hard_judge, TestHardJudge)
#include "tst_hard_judge.moc"
