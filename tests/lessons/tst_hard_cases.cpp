// The lesson on hard cases: which runs fail, and the numbers in its texts.

#include "sim/run/script/script.h"
#include "sim/scene/scene.h"
#include "tests/lessons/support/hard_cases_support.h"

#include "sim/base/direction.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace hard_cases_support;

namespace {

/// The published method for a foot and a body on one spring, transcribed from print. The foot moves first,
/// then the body.
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

class HardCases : public QObject, private HardCaseScripts
{
    Q_OBJECT

private slots:
    void undampedLimitMatchesClosedForm();
    void halfStepAllowsFourTimesTheStiffness();
    void dampedLimitMatchesText_data();
    void dampedLimitMatchesText();
    void implicitMidpointKeepsEnergyAtAnyStiffness_data();
    void implicitMidpointKeepsEnergyAtAnyStiffness();
    void publishedPairMatchesPrintedCode();
    void publishedPairNeverRests();
    void softerPairRestsWhereTextSays();
    void simultaneousForcesKeepTheCentreOfMass();
    void stableNumberOfFeetMatchesText();
    void feetActLikeTheSpringInTheText();
    void publishedMethodKeepsCoincidentFeetTogether();
    void coincidentPairsGetDistinctDirections();
    void companionRunsAreStable_data();
    void companionRunsAreStable();
};

void HardCases::undampedLimitMatchesClosedForm()
{
    QVERIFY(narrationContains("limit", u"exactly **k h² = 4**"_qs) &&
            narrationContains("limit", u"k is 4.01"_qs));
    const auto scriptWith = [&](double k) {
        return scriptFor("limit", "semi_implicit_euler", 1.0, {{"k", k}});
    };
    const double below = maxOverFrames(scriptWith(3.9), 0, 5000, maxDistance);
    QVERIFY(below <= 20.0 / std::sqrt(1.0 - 3.9 / 4.0) + 1e-6);
    QVERIFY(below > 120.0);
    for (int n : {1, 10, 100}) {
        const double x = stateAfter(scriptWith(4.0), n).positionOf(0).x - centre;
        QCOMPARE(x, (n % 2 ? -20.0 : 20.0) * (2 * n + 1));
    }
    const double x = stateAfter(scriptWith(4.01), 300).positionOf(0).x - centre;
    const double next = stateAfter(scriptWith(4.01), 301).positionOf(0).x - centre;
    const double factor = 1.005 + std::sqrt(1.005 * 1.005 - 1.0);
    QVERIFY(std::abs(-next / x - factor) < 1e-9);
}

void HardCases::halfStepAllowsFourTimesTheStiffness()
{
    QVERIFY(narrationContains("limit", u"bears **four times** the stiffness"_qs));
    const auto scriptWith = [&](double k) {
        return scriptFor("limit", "semi_implicit_euler", 0.5, {{"k", k}});
    };
    QVERIFY(maxOverFrames(scriptWith(15.9), 0, 2000, maxDistance) <=
            20.0 / std::sqrt(1.0 - 15.9 / 16.0) + 1e-6);
    QVERIFY(maxOverFrames(scriptWith(16.1), 0, 200, maxDistance) > 1e6);
}

void HardCases::dampedLimitMatchesText_data()
{
    QTest::addColumn<double>("damp");
    for (double damp : {0.9, 0.85, 0.5})
        QTest::addRow("damp %g", damp) << damp;
}

void HardCases::dampedLimitMatchesText()
{
    QVERIFY(narrationContains("limit", u"k = 2 (1 + damp) / damp"_qs));
    QFETCH(double, damp);
    const double limit = 2.0 * (1.0 + damp) / damp;
    const auto scriptWith = [&](double k) {
        return scriptFor("limit", "semi_implicit_euler", 1.0, {{"k", k}, {"damp", damp}});
    };
    QVERIFY(maxDistance(stateAfter(scriptWith(0.99 * limit), 3000)) < 1e-6);
    QVERIFY(maxDistance(stateAfter(scriptWith(1.01 * limit), 3000)) > 1e6);
}

void HardCases::implicitMidpointKeepsEnergyAtAnyStiffness_data()
{
    QTest::addColumn<double>("k");
    for (double k : {0.2, 4.01, 1e3, 1e9})
        QTest::addRow("k %g", k) << k;
}

void HardCases::implicitMidpointKeepsEnergyAtAnyStiffness()
{
    QFETCH(double, k);
    const auto energy = [k](const sim::State &state) {
        return std::pow(state.positionOf(0).x - centre, 2) + std::pow(state.velocityOf(0).x, 2) / k;
    };
    QVERIFY(
        std::abs(maxOverFrames(scriptFor("limit", "implicit_midpoint", 1.0, {{"k", k}}), 0, 3000, energy) -
                 400.0) < 1e-3);
}

void HardCases::publishedPairMatchesPrintedCode()
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

void HardCases::publishedPairNeverRests()
{
    QVERIFY(narrationContains("runaway", u"never comes to rest"_qs));
    PrintedPair pair;
    for (int frame = 0; frame < 20'000; ++frame) {
        pair.frame();
        if (frame > 50)
            QVERIFY(std::hypot(pair.vx[1], pair.vy[1]) > 1.0);
    }
    sim::Track track(step("runaway").script(), 0);
    track.seek({5000, 0});
    QVERIFY(maxSpeed(track.state()) > 1.0);
    QVERIFY(sim::length(centroidOf(track.state()) - sim::Vec2{300.0, 230.0}) > 1000.0);
}

void HardCases::softerPairRestsWhereTextSays()
{
    const sim::State end = stateAfter(scriptFor("runaway", "published", 1.0, {{"k", 0.2}}), 3000);
    QVERIFY(maxSpeed(end) < 1e-6);
    QVERIFY(std::abs(distanceBetween(end, 0, 1) - 50.0) < 1e-6);
    QVERIFY(step("runaway").tries[1].text.contains(u"157\u202fpx"_qs));
    QCOMPARE(std::round(sim::length(centroidOf(end) - sim::Vec2{300.0, 230.0})), 157.0);
}

void HardCases::simultaneousForcesKeepTheCentreOfMass()
{
    const auto centroidShift = [](const sim::State &state) {
        return sim::length(centroidOf(state) - sim::Vec2{300.0, 230.0});
    };
    const sim::Script script = scriptFor("runaway", "semi_implicit_euler");
    QVERIFY(maxOverFrames(script, 0, 3000, centroidShift) < 1e-9);
    QVERIFY(std::abs(distanceBetween(stateAfter(script, 3000), 0, 1) - 50.0) < 1e-9);
}

void HardCases::stableNumberOfFeetMatchesText()
{
    QVERIFY(narrationContains("many_feet", u"so 38 feet hold here, and 41 do not"_qs));
    const auto distanceWith = [&](double feet, const char *method) {
        return maxOverFrames(scriptFor("many_feet", method, 1.0, {{"feet", feet}}), 0, 600, maxDistance);
    };
    QVERIFY(distanceWith(38, "semi_implicit_euler") < 100.0);
    QVERIFY(distanceWith(41, "semi_implicit_euler") > 1e6);
    QVERIFY(distanceWith(60, "semi_implicit_euler") > 1e6);
    QVERIFY(distanceWith(100, "backward_euler") < 100.0);
}

void HardCases::feetActLikeTheSpringInTheText()
{
    QVERIFY(narrationContains("many_feet", u"k (1 + feet / 2)"_qs) &&
            narrationContains("many_feet", u"about 41 feet"_qs));
    const double limit = 2.0 * 1.85 / 0.85;
    QVERIFY(narrationContains("many_feet", u"is 4.35"_qs) && std::abs(limit - 4.35) < 0.005);
    QVERIFY(0.2 * (1.0 + 41.0 / 2.0) < limit && 0.2 * (1.0 + 42.0 / 2.0) > limit);
    // Undamped, a slightly displaced body oscillates with the period 2 pi / sqrt(k (1 + n / 2)) frames.
    const double feet = 8.0, k = 0.02;
    sim::Script script = scriptFor("many_feet", "dop853", 1.0, {{"feet", feet}, {"k", k}, {"damp", 1.0}});
    script.step = sim::StepSize::withTolerance(1e-9);
    const sim::Scene scene = script.build(script.values);
    const sim::Vec2 body = scene.start.positionOf(8);
    for (int i = 0; i < 8; ++i) {
        const sim::Vec2 toFoot = scene.start.positionOf(i) - body;
        script.bodies["foot" + std::to_string(i)] = {body + (50.0 / sim::length(toFoot)) * toFoot,
                                                     sim::Vec2{}};
    }
    script.bodies["body"] = {body, sim::Vec2{0.01, 0.0}};
    const double angularFrequency = std::sqrt(k * (1.0 + feet / 2.0));
    sim::Track track(script, 0);
    for (int frame = 1; frame <= 40; ++frame) {
        track.seek({frame, 0});
        // The body oscillates about a centre of mass that glides on. In x the n feet count as n / 2, because
        // a leg transmits only the component along itself.
        const double share = feet / 2.0 / (1.0 + feet / 2.0);
        const double glided = 0.01 / (1.0 + feet / 2.0) * frame;
        const double expected = glided + share * 0.01 * std::sin(angularFrequency * frame) / angularFrequency;
        QVERIFY(std::abs(track.state().positionOf(8).x - body.x - expected) < 1e-4);
    }
}

void HardCases::publishedMethodKeepsCoincidentFeetTogether()
{
    QVERIFY(narrationContains("one_place", u"what was five feet is one for ever"_qs));
    sim::Track track(step("one_place").script(), 0);
    for (int frame = 1; frame <= 600; ++frame) {
        track.seek({frame, 0});
        for (int i = 1; i < 5; ++i)
            QVERIFY(track.state().positionOf(i) == track.state().positionOf(0));
        QVERIFY(track.state().positionOf(0).x > track.state().positionOf(5).x);
        QCOMPARE(track.state().positionOf(5).y, 200.0);
    }
}

void HardCases::coincidentPairsGetDistinctDirections()
{
    QVERIFY(narrationContains("one_place", u"turns by the golden angle"_qs));
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const sim::State first = stateAfter(scriptFor("one_place", "semi_implicit_euler"), 1);
    for (int i = 0; i < 4; ++i) {
        const sim::Vec2 a = first.velocityOf(i), b = first.velocityOf(i + 1);
        const double turned = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        QVERIFY(std::abs(turned - golden) < 1e-9);
    }
    for (int i = 0; i < 5; ++i)
        QVERIFY(sim::length(sim::fallbackDirection(i, 5) + sim::fallbackDirection(5, i)) < 1e-15);
    const sim::State end = stateAfter(scriptFor("one_place", "semi_implicit_euler"), 300);
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < i; ++j)
            QVERIFY(distanceBetween(end, i, j) > 10.0);
    }
    QVERIFY(maxLegError(end) < 1e-6);
}

void HardCases::companionRunsAreStable_data()
{
    QTest::addColumn<QString>("id");
    for (const lessons::Step &each : m_lesson.steps) {
        if (each.companion)
            QTest::newRow(qPrintable(each.id)) << each.id;
    }
}

void HardCases::companionRunsAreStable()
{
    QFETCH(QString, id);
    const lessons::Step &lessonStep = m_lesson.step(id);
    sim::Script script =
        scriptOf(lessonStep, lessonStep.companion->method.toStdString(), lessonStep.companion->h);
    for (const auto &[name, value] : lessonStep.companion->values)
        script.values.set(name.toStdString(), value);
    QVERIFY(maxOverFrames(script, 0, 3000, maxDistance) < 150.0);
    QVERIFY(!lessonStep.companion->caption.isEmpty());
    QVERIFY(lessonStep.companion->offset != sim::Vec2{});
}

SUITE(tst_hard_cases, HardCases)
#include "tst_hard_cases.moc"
