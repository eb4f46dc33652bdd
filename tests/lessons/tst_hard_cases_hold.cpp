// The lesson on hard cases: setups that stay stable. They use small steps, implicit methods, sticks, or
// methods without energy drift.

#include "sim/run/script/script.h"
#include "tests/lessons/support/hard_cases_support.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace hard_cases_support;

class HardCasesHold : public QObject, private HardCaseScripts
{
    Q_OBJECT

private slots:
    void stiffLegsDivergeInOneStep();
    void stiffLegsNeedTheStepInTheText();
    void backwardEulerIsStableAtAnyStiffness();
    void backwardEulerDampsAsPredicted();
    void contradictorySpringsHaveTheLimitInTheText();
    void contradictorySticksSettleAndTheLastIsExact();
    void rungeKuttaDampsAsPredicted();
    void verletLosesNoEnergy();
};

void HardCasesHold::stiffLegsDivergeInOneStep()
{
    QVERIFY(narrationContains("stiff", u"the feet 20 000 px away"_qs));
    const double distance = maxDistance(stateAfter(step("stiff").script(), 1));
    QVERIFY(std::abs(distance - 20'000.0) < 500.0);
    sim::Track track(step("stiff").script(), 0);
    track.seek({1000, 0});
    QVERIFY(track.stop());
    QVERIFY(track.state().position.isFinite().all());
    QVERIFY(!track.stop()->body.empty());
}

void HardCasesHold::stiffLegsNeedTheStepInTheText()
{
    QVERIFY(narrationContains("stiff", u"1/32 of a frame is too long still, 1/64 holds"_qs));
    const sim::State coarse = stateAfter(scriptFor("stiff", "semi_implicit_euler", 1.0 / 32), 300);
    QVERIFY(!(maxLegError(coarse) < 100.0));
    const sim::State fine = stateAfter(scriptFor("stiff", "semi_implicit_euler", 1.0 / 64), 300);
    QVERIFY(maxLegError(fine) < 0.01 && maxSpeed(fine) < 0.01);
}

void HardCasesHold::backwardEulerIsStableAtAnyStiffness()
{
    for (double k : {1e3, 1e6, 1e9}) {
        const sim::Script script = scriptFor("stiff", "backward_euler", 1.0, {{"k", k}});
        QVERIFY2(maxOverFrames(script, 10, 600, maxLegError) < 0.01, qPrintable(QString::number(k)));
    }
}

void HardCasesHold::backwardEulerDampsAsPredicted()
{
    const sim::State end = stateAfter(scriptFor("limit", "backward_euler", 1.0, {{"k", 0.2}}), 50);
    const double swing = std::hypot(end.positionOf(0).x - centre, end.velocityOf(0).x / std::sqrt(0.2));
    QVERIFY(std::abs(swing / (20.0 * std::pow(1.2, -25.0)) - 1.0) < 1e-6);
}

void HardCasesHold::contradictorySpringsHaveTheLimitInTheText()
{
    QVERIFY(narrationContains("contradiction", u"like one of 3 k, and the limit is 4.22"_qs));
    QVERIFY(std::abs(2.0 * 1.9 / 0.9 - 4.22) < 0.005 && 3.0 * 1.5 > 4.22);
    const auto scriptWith = [&](double k) {
        return scriptFor("contradiction", "semi_implicit_euler", 1.0, {{"k", k}});
    };
    QVERIFY(maxDistance(stateAfter(scriptWith(1.5), 200)) > 1e6);
    // At k = 1 the error is shared equally: each spring is off by 160 / 3 px.
    const sim::State end = stateAfter(scriptWith(1.0), 1500);
    QVERIFY(std::abs(distanceBetween(end, 0, 1) - (20.0 + 160.0 / 3.0)) < 0.01);
    QVERIFY(std::abs(distanceBetween(end, 1, 2) - (20.0 + 160.0 / 3.0)) < 0.01);
    QVERIFY(std::abs(distanceBetween(end, 0, 2) - (200.0 - 160.0 / 3.0)) < 0.01);
}

void HardCasesHold::contradictorySticksSettleAndTheLastIsExact()
{
    for (const char *method : {"published", "semi_implicit_euler", "velocity_verlet"}) {
        const sim::Script script = scriptFor("contradiction", method, 1.0, {{"made_of", 1.0}});
        QVERIFY(maxOverFrames(script, 0, 3000, maxDistance) < 200.0);
        const sim::State end = stateAfter(script, 3000);
        QVERIFY(maxSpeed(end) < 1e-6);
        QVERIFY(std::abs(distanceBetween(end, 0, 2) - 200.0) < 1e-9);
        QVERIFY(distanceBetween(end, 0, 1) > 40.0 && distanceBetween(end, 1, 2) > 40.0);
    }
    const sim::Script consistent =
        scriptFor("contradiction", "semi_implicit_euler", 1.0, {{"made_of", 1.0}, {"longest", 30.0}});
    const sim::State end = stateAfter(consistent, 300);
    QVERIFY(std::abs(distanceBetween(end, 0, 1) - 20.0) < 1e-6 &&
            std::abs(distanceBetween(end, 0, 2) - 30.0) < 1e-6);
}

void HardCasesHold::rungeKuttaDampsAsPredicted()
{
    QVERIFY(narrationContains("long_run", u"takes 0.08 % of the swing"_qs) &&
            narrationContains("long_run", u"After **851 frames** half is left"_qs));
    const std::complex<double> z(0.0, std::sqrt(0.5));
    const double factor = std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0);
    QVERIFY(std::abs(100.0 * (1.0 - factor) - 0.08) < 0.005);
    for (int frames : {10, 851, 5000}) {
        const sim::State end = stateAfter(step("long_run").script(), frames);
        const double swing = std::hypot(end.positionOf(0).x - centre, end.velocityOf(0).x / std::sqrt(0.5));
        QVERIFY(std::abs(swing / (120.0 * std::pow(factor, frames)) - 1.0) < 1e-9);
        if (frames == 851)
            QVERIFY(std::abs(swing - 60.0) < 0.05);
    }
}

void HardCasesHold::verletLosesNoEnergy()
{
    const sim::Script script = scriptFor("long_run", "velocity_verlet");
    const double angle = std::acos(0.75);
    QVERIFY(narrationContains("long_run", u"never more than 1.3 px off, Velocity Verlet up to 14 px"_qs));
    double rungeKuttaError = 0.0, verletError = 0.0;
    for (int frame = 1; frame <= 10; ++frame) {
        const double exact = centre + 120.0 * std::cos(std::sqrt(0.5) * frame);
        rungeKuttaError = std::max(
            rungeKuttaError, std::abs(stateAfter(step("long_run").script(), frame).positionOf(0).x - exact));
        verletError = std::max(verletError, std::abs(stateAfter(script, frame).positionOf(0).x - exact));
    }
    QVERIFY(std::abs(rungeKuttaError - 1.3) < 0.05 && std::abs(verletError - 14.0) < 0.5);
    for (int frames : {1, 1000, 20'000})
        QVERIFY(std::abs(stateAfter(script, frames).positionOf(0).x - centre -
                         120.0 * std::cos(frames * angle)) < 1e-6);
}

SUITE(tst_hard_cases_hold, HardCasesHold)
#include "tst_hard_cases_hold.moc"
