// The lesson of hard cases: small steps, implicit methods, sticks, and methods that lose nothing, which hold.

#include "hard_cases_support.h"
#include "sim/run/script/script.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace hard_cases_bench;

class HardCasesHold : public QObject, private HardCases
{
    Q_OBJECT

private slots:
    void stiffLegsAreGoneInOneStep();
    void stiffLegsNeedTheStepsThatTheTextSays();
    void backwardEulerIsCalmAtAnyStiffness();
    void backwardEulerLosesWhatItsRuleSays();
    void contradictorySpringsHaveTheLimitThatTheTextSays();
    void contradictorySticksStayAndTheLastIsRight();
    void rungeKuttaLosesWhatItsRuleSays();
    void verletLosesNothing();
};

void HardCasesHold::stiffLegsAreGoneInOneStep()
{
    QVERIFY(saysOf("stiff", u"the feet 20 000 px away"_qs));
    const double far = reach(stateAfter(step("stiff").script(), 1));
    QVERIFY(std::abs(far - 20'000.0) < 500.0);
    sim::Track track(step("stiff").script(), 0);
    track.seek({1000, 0});
    QVERIFY(track.stop());
    QVERIFY(track.state().position.isFinite().all());
    QVERIFY(!track.stop()->body.empty());
}

void HardCasesHold::stiffLegsNeedTheStepsThatTheTextSays()
{
    QVERIFY(saysOf("stiff", u"1/32 of a frame is too long still, 1/64 holds"_qs));
    const sim::State coarse = stateAfter(run("stiff", "semi_implicit_euler", 1.0 / 32), 300);
    QVERIFY(!(worstLeg(coarse) < 100.0));
    const sim::State fine = stateAfter(run("stiff", "semi_implicit_euler", 1.0 / 64), 300);
    QVERIFY(worstLeg(fine) < 0.01 && fastest(fine) < 0.01);
}

void HardCasesHold::backwardEulerIsCalmAtAnyStiffness()
{
    for (double k : {1e3, 1e6, 1e9}) {
        const sim::Script script = run("stiff", "backward_euler", 1.0, {{"k", k}});
        QVERIFY2(largest(script, 10, 600, worstLeg) < 0.01, qPrintable(QString::number(k)));
    }
}

void HardCasesHold::backwardEulerLosesWhatItsRuleSays()
{
    const sim::State end = stateAfter(run("limit", "backward_euler", 1.0, {{"k", 0.2}}), 50);
    const double swing = std::hypot(end.positionOf(0).x - centre, end.velocityOf(0).x / std::sqrt(0.2));
    QVERIFY(std::abs(swing / (20.0 * std::pow(1.2, -25.0)) - 1.0) < 1e-6);
}

void HardCasesHold::contradictorySpringsHaveTheLimitThatTheTextSays()
{
    QVERIFY(saysOf("contradiction", u"like one of 3 k, and the limit is 4.22"_qs));
    QVERIFY(std::abs(2.0 * 1.9 / 0.9 - 4.22) < 0.005 && 3.0 * 1.5 > 4.22);
    const auto at = [&](double k) { return run("contradiction", "semi_implicit_euler", 1.0, {{"k", k}}); };
    QVERIFY(reach(stateAfter(at(1.5), 200)) > 1e6);
    // At k = 1 they share the error: the stretch of the short ones is the squeeze of the long one, 160 / 3 px.
    const sim::State end = stateAfter(at(1.0), 1500);
    QVERIFY(std::abs(apart(end, 0, 1) - (20.0 + 160.0 / 3.0)) < 0.01);
    QVERIFY(std::abs(apart(end, 1, 2) - (20.0 + 160.0 / 3.0)) < 0.01);
    QVERIFY(std::abs(apart(end, 0, 2) - (200.0 - 160.0 / 3.0)) < 0.01);
}

void HardCasesHold::contradictorySticksStayAndTheLastIsRight()
{
    for (const char *method : {"published", "semi_implicit_euler", "velocity_verlet"}) {
        const sim::Script script = run("contradiction", method, 1.0, {{"made_of", 1.0}});
        QVERIFY(largest(script, 0, 3000, reach) < 200.0);
        const sim::State end = stateAfter(script, 3000);
        QVERIFY(fastest(end) < 1e-6);
        QVERIFY(std::abs(apart(end, 0, 2) - 200.0) < 1e-9);
        QVERIFY(apart(end, 0, 1) > 40.0 && apart(end, 1, 2) > 40.0);
    }
    const sim::Script fits =
        run("contradiction", "semi_implicit_euler", 1.0, {{"made_of", 1.0}, {"longest", 30.0}});
    const sim::State end = stateAfter(fits, 300);
    QVERIFY(std::abs(apart(end, 0, 1) - 20.0) < 1e-6 && std::abs(apart(end, 0, 2) - 30.0) < 1e-6);
}

void HardCasesHold::rungeKuttaLosesWhatItsRuleSays()
{
    QVERIFY(saysOf("long_run", u"takes 0.08 % of the swing"_qs) &&
            saysOf("long_run", u"After **851 frames** half is left"_qs));
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

void HardCasesHold::verletLosesNothing()
{
    const sim::Script script = run("long_run", "velocity_verlet");
    const double angle = std::acos(0.75);
    QVERIFY(saysOf("long_run", u"never more than 1.3 px off, Velocity Verlet up to 14 px"_qs));
    double runge = 0.0, verlet = 0.0;
    for (int frame = 1; frame <= 10; ++frame) {
        const double exact = centre + 120.0 * std::cos(std::sqrt(0.5) * frame);
        runge =
            std::max(runge, std::abs(stateAfter(step("long_run").script(), frame).positionOf(0).x - exact));
        verlet = std::max(verlet, std::abs(stateAfter(script, frame).positionOf(0).x - exact));
    }
    QVERIFY(std::abs(runge - 1.3) < 0.05 && std::abs(verlet - 14.0) < 0.5);
    for (int frames : {1, 1000, 20'000})
        QVERIFY(std::abs(stateAfter(script, frames).positionOf(0).x - centre -
                         120.0 * std::cos(frames * angle)) < 1e-6);
}

QTEST_GUILESS_MAIN(HardCasesHold)
#include "tst_hard_cases_hold.moc"
