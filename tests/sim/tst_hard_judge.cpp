// A judge that lets nothing pass: each of its looks finds what was made wrong on purpose.

#include "sim/base/error.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"

#include <QTest>

using namespace sim;

namespace {

/// A case that holds, made to fail by `spoil`.
template <class Spoil>
std::string whyNot(const char *id, Spoil &&spoil)
{
    HardCase one = findHardCase(id).value();
    const MethodPtr method = findMethod("semi_implicit_euler");
    if (!judge(one, method, one.brief).holds)
        return "it does not hold as it is";
    spoil(one);
    const Verdict verdict = judge(one, method, one.brief);
    return verdict.holds ? "it holds" : verdict.why->id();
}

}

class TestHardJudge : public QObject
{
    Q_OBJECT

private slots:
    void aBoundThatIsTooTight();
    void aMiddleThatMoves();
    void anotherPlaceOfRest();
    void anotherLengthAtRest();
    void somethingThatStillMoves();
    void aStickThatIsWrong();
    void aRefusalThatDoesNotCome();
    void anEndThatDoesNotCome();
    void restIsAskedForOnlyWhenThereWasTime();
};

void TestHardJudge::aBoundThatIsTooTight()
{
    const auto spoil = [](HardCase &one) { one.bound.reach = 99.0; };
    QCOMPARE(whyNot("damp_1", spoil), std::string("hard-too-far"));
}

void TestHardJudge::aMiddleThatMoves()
{
    // What a hand takes elsewhere is not where it was.
    const auto spoil = [](HardCase &one) {
        one.script.input = {{5, Grab{"body"}}, {6, Move{{280.0, 200.0}}}, {7, Release{}}};
    };
    QCOMPARE(whyNot("runaway_pair", spoil), std::string("hard-drifts"));
}

void TestHardJudge::anotherPlaceOfRest()
{
    const auto spoil = [](HardCase &one) { one.rest->places.front().x.x += 1e-3; };
    QCOMPARE(whyNot("step_third", spoil), std::string("hard-elsewhere"));
}

void TestHardJudge::anotherLengthAtRest()
{
    const auto spoil = [](HardCase &one) { one.rest->distances.front().length += 1e-3; };
    QCOMPARE(whyNot("runaway_pair", spoil), std::string("hard-length"));
}

void TestHardJudge::somethingThatStillMoves()
{
    const auto spoil = [](HardCase &one) { one.script.values.set("damp", 1.0); };
    QCOMPARE(whyNot("runaway_pair", spoil), std::string("hard-moves"));
}

void TestHardJudge::aStickThatIsWrong()
{
    const auto spoil = [](HardCase &one) { one.stickError = 1.0; };
    QCOMPARE(whyNot("contradictory_triangle", spoil), std::string("hard-stick"));
}

void TestHardJudge::aRefusalThatDoesNotCome()
{
    const auto spoil = [](HardCase &one) { one.script.input = {}; };
    QCOMPARE(whyNot("hand_not_a_number", spoil), std::string("hard-not-refused"));
}

void TestHardJudge::anEndThatDoesNotCome()
{
    const auto spoil = [](HardCase &one) { one.script.input = {}; };
    QCOMPARE(whyNot("wind_no_distance_published", spoil), std::string("hard-does-not-end"));
}

void TestHardJudge::restIsAskedForOnlyWhenThereWasTime()
{
    HardCase one = findHardCase("step_third").value();
    const MethodPtr method = findMethod("semi_implicit_euler");
    RunSize size = one.brief;
    size.frames = 30; // far from rest
    QVERIFY(judge(one, method, size).holds);
    one.rest->after = 30;
    QVERIFY(!judge(one, method, size).holds);
}

QTEST_GUILESS_MAIN(TestHardJudge)
#include "tst_hard_judge.moc"
