// The lesson of hard cases: what breaks, and where its texts say so.

#include "hard_cases_support.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"

#include "sim/base/direction.h"
#include "tests/lessons/attempts.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace hard_cases_bench;

namespace {

/// The printed rule for a foot and a body on one spring, written down a second time: the foot moves, then the body.
struct PrintedPair
{
    double k = 0.3;
    double x[2] = {330.0, 270.0}, y[2] = {260.0, 200.0}, vx[2] = {0.0, 0.0}, vy[2] = {0.0, 0.0};

    void frame()
    {
        for (int i = 0; i < 2; ++i) {
            const double angle = std::atan2(y[i] - y[1 - i], x[i] - x[1 - i]);
            vx[i] += (x[1 - i] + std::cos(angle) * 50.0 - x[i]) * k;
            vy[i] += (y[1 - i] + std::sin(angle) * 50.0 - y[i]) * k;
            vx[i] *= 0.9;
            vy[i] *= 0.9;
            x[i] += vx[i];
            y[i] += vy[i];
        }
    }
};

}

class HardCasesLesson : public QObject, private HardCases
{
    Q_OBJECT

private slots:
    void withoutDampingTheLimitIsWhereTheClosedFormHasIt();
    void halfAStepBearsFourTimesTheStiffness();
    void dampingMovesTheLimitAsTheTextSays_data();
    void dampingMovesTheLimitAsTheTextSays();
    void implicitMidpointKeepsTheSwingAtAnyStiffness_data();
    void implicitMidpointKeepsTheSwingAtAnyStiffness();
    void thePrintedPairIsThatOfThePrintedRule();
    void thePrintedPairNeverRests();
    void aSofterPairRestsWhereTheTextSays();
    void simultaneousPullsKeepTheMiddle();
    void asManyFeetHoldAsTheTextSays();
    void aLineOfFeetSwingsLikeTheSpringThatTheTextNames();
    void inOnePlaceThePrintedRuleMakesOneFootOfFive();
    void inOnePlaceEachPairHasADirectionOfItsOwn();
    void everyCompanionHolds_data();
    void everyCompanionHolds();
    void everyTryIsDoneByWhatItDescribes_data() { addAttemptRows(m_lesson, attempts()); }
    void everyTryIsDoneByWhatItDescribes() { checkAttempt(m_lesson); }
};

void HardCasesLesson::withoutDampingTheLimitIsWhereTheClosedFormHasIt()
{
    QVERIFY(saysOf("limit", u"exactly **k h² = 4**"_qs) && saysOf("limit", u"k is 4.01"_qs));
    const auto swingOf = [&](double k) { return run("limit", "semi_implicit_euler", 1.0, {{"k", k}}); };
    const double below = largest(swingOf(3.9), 0, 5000, reach);
    QVERIFY(below <= 20.0 / std::sqrt(1.0 - 3.9 / 4.0) + 1e-6);
    QVERIFY(below > 120.0);
    for (int n : {1, 10, 100}) {
        const double x = stateAfter(swingOf(4.0), n).positionOf(0).x - centre;
        QCOMPARE(x, (n % 2 ? -20.0 : 20.0) * (2 * n + 1));
    }
    const double x = stateAfter(swingOf(4.01), 300).positionOf(0).x - centre;
    const double next = stateAfter(swingOf(4.01), 301).positionOf(0).x - centre;
    const double factor = 1.005 + std::sqrt(1.005 * 1.005 - 1.0);
    QVERIFY(std::abs(-next / x - factor) < 1e-9);
}

void HardCasesLesson::halfAStepBearsFourTimesTheStiffness()
{
    QVERIFY(saysOf("limit", u"bears **four times** the stiffness"_qs));
    const auto swingOf = [&](double k) { return run("limit", "semi_implicit_euler", 0.5, {{"k", k}}); };
    QVERIFY(largest(swingOf(15.9), 0, 2000, reach) <= 20.0 / std::sqrt(1.0 - 15.9 / 16.0) + 1e-6);
    QVERIFY(largest(swingOf(16.1), 0, 200, reach) > 1e6);
}

void HardCasesLesson::dampingMovesTheLimitAsTheTextSays_data()
{
    QTest::addColumn<double>("damp");
    for (double damp : {0.9, 0.85, 0.5})
        QTest::addRow("damp %g", damp) << damp;
}

void HardCasesLesson::dampingMovesTheLimitAsTheTextSays()
{
    QVERIFY(saysOf("limit", u"k = 2 (1 + damp) / damp"_qs));
    QFETCH(double, damp);
    const double limit = 2.0 * (1.0 + damp) / damp;
    const auto at = [&](double k) {
        return run("limit", "semi_implicit_euler", 1.0, {{"k", k}, {"damp", damp}});
    };
    QVERIFY(reach(stateAfter(at(0.99 * limit), 3000)) < 1e-6);
    QVERIFY(reach(stateAfter(at(1.01 * limit), 3000)) > 1e6);
}

void HardCasesLesson::implicitMidpointKeepsTheSwingAtAnyStiffness_data()
{
    QTest::addColumn<double>("k");
    for (double k : {0.2, 4.01, 1e3, 1e9})
        QTest::addRow("k %g", k) << k;
}

void HardCasesLesson::implicitMidpointKeepsTheSwingAtAnyStiffness()
{
    QFETCH(double, k);
    const auto energy = [k](const sim::State &state) {
        return std::pow(state.positionOf(0).x - centre, 2) + std::pow(state.velocityOf(0).x, 2) / k;
    };
    QVERIFY(std::abs(largest(run("limit", "implicit_midpoint", 1.0, {{"k", k}}), 0, 3000, energy) - 400.0) <
            1e-3);
}

void HardCasesLesson::thePrintedPairIsThatOfThePrintedRule()
{
    PrintedPair pair;
    sim::Track track(step("runaway").script(), 0);
    for (int frame = 1; frame <= 40; ++frame) {
        pair.frame();
        track.seek({frame, 0});
        for (int i : {0, 1})
            QVERIFY(sim::length(track.state().positionOf(i) - sim::Vec2{pair.x[i], pair.y[i]}) < 1e-9);
    }
}

void HardCasesLesson::thePrintedPairNeverRests()
{
    QVERIFY(saysOf("runaway", u"never comes to rest"_qs));
    PrintedPair pair;
    for (int frame = 0; frame < 20'000; ++frame) {
        pair.frame();
        if (frame > 50)
            QVERIFY(std::hypot(pair.vx[1], pair.vy[1]) > 1.0);
    }
    sim::Track track(step("runaway").script(), 0);
    track.seek({5000, 0});
    QVERIFY(fastest(track.state()) > 1.0);
    QVERIFY(sim::length(middleOf(track.state()) - sim::Vec2{300.0, 230.0}) > 1000.0);
}

void HardCasesLesson::aSofterPairRestsWhereTheTextSays()
{
    const sim::State end = stateAfter(run("runaway", "published", 1.0, {{"k", 0.2}}), 3000);
    QVERIFY(fastest(end) < 1e-6);
    QVERIFY(std::abs(apart(end, 0, 1) - 50.0) < 1e-6);
    QVERIFY(step("runaway").tries[1].text.contains(u"157\u2009px"_qs));
    QCOMPARE(std::round(sim::length(middleOf(end) - sim::Vec2{300.0, 230.0})), 157.0);
}

void HardCasesLesson::simultaneousPullsKeepTheMiddle()
{
    const auto off = [](const sim::State &state) {
        return sim::length(middleOf(state) - sim::Vec2{300.0, 230.0});
    };
    const sim::Script script = run("runaway", "semi_implicit_euler");
    QVERIFY(largest(script, 0, 3000, off) < 1e-9);
    QVERIFY(std::abs(apart(stateAfter(script, 3000), 0, 1) - 50.0) < 1e-9);
}

void HardCasesLesson::asManyFeetHoldAsTheTextSays()
{
    QVERIFY(saysOf("many_feet", u"so 38 feet hold here, and 41 do not"_qs));
    const auto with = [&](double feet, const char *method) {
        return largest(run("many_feet", method, 1.0, {{"feet", feet}}), 0, 600, reach);
    };
    QVERIFY(with(38, "semi_implicit_euler") < 100.0);
    QVERIFY(with(41, "semi_implicit_euler") > 1e6);
    QVERIFY(with(60, "semi_implicit_euler") > 1e6);
    QVERIFY(with(100, "backward_euler") < 100.0);
}

void HardCasesLesson::aLineOfFeetSwingsLikeTheSpringThatTheTextNames()
{
    QVERIFY(saysOf("many_feet", u"k (1 + feet / 2)"_qs) && saysOf("many_feet", u"about 41 feet"_qs));
    const double limit = 2.0 * 1.85 / 0.85;
    QVERIFY(saysOf("many_feet", u"is 4.35"_qs) && std::abs(limit - 4.35) < 0.005);
    QVERIFY(0.2 * (1.0 + 41.0 / 2.0) < limit && 0.2 * (1.0 + 42.0 / 2.0) > limit);
    // Undamped, a body that is a little off swings with that pace: once in 2 pi / sqrt(k (1 + n / 2)) frames.
    const double feet = 8.0, k = 0.02;
    sim::Script script = run("many_feet", "dop853", 1.0, {{"feet", feet}, {"k", k}, {"damp", 1.0}});
    script.step = sim::StepSize::withTolerance(1e-9);
    const sim::Scene scene = script.build(script.values);
    const sim::Vec2 body = scene.start.positionOf(8);
    for (int i = 0; i < 8; ++i) {
        const sim::Vec2 out = scene.start.positionOf(i) - body;
        script.bodies["foot" + std::to_string(i)] = {body + (50.0 / sim::length(out)) * out, sim::Vec2{}};
    }
    script.bodies["body"] = {body, sim::Vec2{0.01, 0.0}};
    const double pace = std::sqrt(k * (1.0 + feet / 2.0));
    sim::Track track(script, 0);
    for (int frame = 1; frame <= 40; ++frame) {
        track.seek({frame, 0});
        // The body against the middle of all nine, which glides on; the feet along it are half of all.
        const double share = feet / 2.0 / (1.0 + feet / 2.0);
        const double along = 0.01 / (1.0 + feet / 2.0) * frame;
        const double expected = along + share * 0.01 * std::sin(pace * frame) / pace;
        QVERIFY(std::abs(track.state().positionOf(8).x - body.x - expected) < 1e-4);
    }
}

void HardCasesLesson::inOnePlaceThePrintedRuleMakesOneFootOfFive()
{
    QVERIFY(saysOf("one_place", u"what was five feet is one for ever"_qs));
    sim::Track track(step("one_place").script(), 0);
    for (int frame = 1; frame <= 600; ++frame) {
        track.seek({frame, 0});
        for (int i = 1; i < 5; ++i)
            QVERIFY(track.state().positionOf(i) == track.state().positionOf(0));
        QVERIFY(track.state().positionOf(0).x > track.state().positionOf(5).x);
        QCOMPARE(track.state().positionOf(5).y, 200.0);
    }
}

void HardCasesLesson::inOnePlaceEachPairHasADirectionOfItsOwn()
{
    QVERIFY(saysOf("one_place", u"turns by the golden angle"_qs));
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const sim::State first = stateAfter(run("one_place", "semi_implicit_euler"), 1);
    for (int i = 0; i < 4; ++i) {
        const sim::Vec2 a = first.velocityOf(i), b = first.velocityOf(i + 1);
        const double turned = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        QVERIFY(std::abs(turned - golden) < 1e-9);
    }
    for (int i = 0; i < 5; ++i)
        QVERIFY(sim::length(sim::fallbackDirection(i, 5) + sim::fallbackDirection(5, i)) < 1e-15);
    const sim::State end = stateAfter(run("one_place", "semi_implicit_euler"), 300);
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < i; ++j)
            QVERIFY(apart(end, i, j) > 10.0);
    }
    QVERIFY(worstLeg(end) < 1e-6);
}

void HardCasesLesson::everyCompanionHolds_data()
{
    QTest::addColumn<QString>("id");
    for (const lessons::Step &one : m_lesson.steps) {
        if (one.companion)
            QTest::newRow(qPrintable(one.id)) << one.id;
    }
}

void HardCasesLesson::everyCompanionHolds()
{
    QFETCH(QString, id);
    const lessons::Step &one = m_lesson.step(id);
    sim::Script script = scriptOf(one, one.companion->method.toStdString(), one.companion->h);
    for (const auto &[name, value] : one.companion->values)
        script.values.set(name.toStdString(), value);
    QVERIFY(largest(script, 0, 3000, reach) < 150.0);
    QVERIFY(!one.companion->caption.isEmpty());
    QVERIFY(one.companion->offset != sim::Vec2{});
}

QTEST_GUILESS_MAIN(HardCasesLesson)
#include "tst_hard_cases.moc"
