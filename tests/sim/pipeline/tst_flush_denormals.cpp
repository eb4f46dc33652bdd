// Denormal numbers count as 0 while a run is computed, and only then.

#include "tests/sim/support/support.h"

#include "sim/analysis/energy/ledger.h"
#include "sim/effects/drags/damping.h"
#include "sim/simd/flush_denormals.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <thread>

using namespace sim;

namespace {

constexpr double minNormal = std::numeric_limits<double>::min();

/// Returns whether this thread computes with denormals. volatile keeps the compiler from computing in
/// advance.
bool keepsDenormals()
{
    const volatile double denormal = minNormal;
    const volatile double half = 0.5;
    return denormal * half != 0.0;
}

/// Returns a script with a point whose velocity halves each frame.
Script dampedPoint()
{
    Scene scene = scenes::creature(1);
    scene.start.setVelocity(1, {1.0, -1.0});
    scene.effects = {std::make_shared<Damping>(0.5)};
    return support::script(scene, "semi_implicit_euler");
}

bool hasDenormals(const State &state)
{
    const auto denormal = [](const auto &numbers) {
        return (numbers != 0.0 && numbers.abs() < minNormal).any();
    };
    return denormal(state.position) || denormal(state.velocity) || denormal(state.acceleration);
}

}

class TestFlushDenormals : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!FlushDenormals().isActive())
            QSKIP("not on this processor");
    }

    void modeIsRestored()
    {
        QVERIFY(!FlushDenormals::isActive());
        QVERIFY(keepsDenormals());
        {
            const FlushDenormals outer;
            QVERIFY(FlushDenormals::isActive());
            QVERIFY(!keepsDenormals());
            {
                const FlushDenormals inner;
                QVERIFY(!keepsDenormals());
            }
            QVERIFY(!keepsDenormals());
        }
        QVERIFY(!FlushDenormals::isActive());
        QVERIFY(keepsDenormals());
    }

    void modeAffectsOnlyItsThread()
    {
        bool otherKeepsThem = false;
        std::thread other([&] { otherKeepsThem = keepsDenormals(); });
        const FlushDenormals flush;
        other.join();
        QVERIFY(otherKeepsThem);
    }

    void decayingVelocityReachesZero()
    {
        // 2^-1022 is the smallest normal number. It is reached after 1022 halvings, and flushed after one
        // more.
        Track track(dampedPoint(), 1 << 20);
        track.seek({1022, 0});
        QCOMPARE(track.state().velocityOf(1).x, minNormal);
        track.seek({1023, 0});
        QCOMPARE(track.state().velocityOf(1).x, 0.0);
        QCOMPARE(track.state().velocityOf(1).y, 0.0);
        QVERIFY(keepsDenormals());
    }

    void noMethodLeavesDenormals()
    {
        for (const std::string method : {"published", "semi_implicit_euler", "velocity_verlet"}) {
            support::Sample sample = support::sample("creature from one place");
            sample.values.set("damp", 0.6);
            Track track(support::script(sample, method), 1 << 20);
            for (int frame = 0; frame < 3000; ++frame) {
                track.seek({frame, 0});
                QVERIFY2(!hasDenormals(track.state()), method.c_str());
            }
        }
    }

    void everyRunGivesTheSameBits()
    {
        const Script script = dampedPoint();
        Track track(script, 1 << 20), trackWithoutBudget(script, 0);
        for (const int frame : {1020, 1022, 1023, 1024, 1100}) {
            track.seek({frame, 0});
            const State state = track.state();
            QVERIFY(sameBits(support::plainRun(script.build({}), "semi_implicit_euler", 1.0, frame), state));
            QVERIFY(sameBits(track.stateAt(frame), state));
            trackWithoutBudget.seek({frame, 0});
            QVERIFY(sameBits(trackWithoutBudget.state(), state));
            trackWithoutBudget.seek({0, 0});
            trackWithoutBudget.seek({frame - 1, 1});
            trackWithoutBudget.seek({frame, 0});
            QVERIFY(sameBits(trackWithoutBudget.state(), state));
        }
    }

    void explanationsHaveTheNumbersOfTheRun()
    {
        Track track(dampedPoint(), 1 << 20);
        track.seek({1023, 0});
        bool found = false;
        for (const PhaseExplanation &explanation : track.explainPhases("body")) {
            for (const LiveValue &live : explanation.live) {
                if (live.name != "v")
                    continue;
                QCOMPARE(std::get<Vec2>(live.value).x, 0.0);
                QCOMPARE(std::get<Vec2>(*live.before).x, minNormal);
                found = true;
            }
        }
        QVERIFY(found);
    }

    void ledgerEndsAtTheStateOfTheRun()
    {
        Track track(dampedPoint(), 1 << 20);
        track.seek({1024, 0});
        Ledger ledger;
        const std::optional<Balance> step = ledger.balanceAt(track, 1023);
        QVERIFY(step);
        QCOMPARE(step->after.momentum.x, 0.0);
        QVERIFY(keepsDenormals());
    }
};

SUITE(tst_flush_denormals, TestFlushDenormals)
#include "tst_flush_denormals.moc"
