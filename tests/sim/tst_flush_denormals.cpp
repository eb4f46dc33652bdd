// Numbers too small for full precision count as 0 while a run is computed, and only then.

#include "support.h"

#include "sim/analysis/energy/ledger.h"
#include "sim/effects/drags/damping.h"
#include "sim/simd/flush_denormals.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <thread>

using namespace sim;

namespace {

constexpr double least = std::numeric_limits<double>::min();

/// Whether this machine computes with numbers below `least`; the compiler must not do it in advance.
bool countsTiny()
{
    const volatile double tiny = least;
    const volatile double half = 0.5;
    return tiny * half != 0.0;
}

/// A point that only slows down: its velocity halves each frame.
Script slowing()
{
    Scene scene = scenes::creature(1);
    scene.start.setVelocity(1, {1.0, -1.0});
    scene.effects = {std::make_shared<Damping>(0.5)};
    return support::script(scene, "semi_implicit_euler");
}

bool hasTiny(const State &state)
{
    const auto tiny = [](const auto &numbers) { return (numbers != 0.0 && numbers.abs() < least).any(); };
    return tiny(state.position) || tiny(state.velocity) || tiny(state.acceleration);
}

}

class TestFlush : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!FlushDenormals().isActive())
            QSKIP("not on this processor");
    }

    void theModeIsBackAfterwards()
    {
        QVERIFY(!FlushDenormals::isActive());
        QVERIFY(countsTiny());
        {
            const FlushDenormals outer;
            QVERIFY(FlushDenormals::isActive());
            QVERIFY(!countsTiny());
            {
                const FlushDenormals inner;
                QVERIFY(!countsTiny());
            }
            QVERIFY(!countsTiny());
        }
        QVERIFY(!FlushDenormals::isActive());
        QVERIFY(countsTiny());
    }

    void itIsOneThreadsOwn()
    {
        bool other = false;
        std::thread before([&] { other = countsTiny(); });
        const FlushDenormals flush;
        before.join();
        QVERIFY(other);
    }

    void whatSettlesComesToRestAtNought()
    {
        // 2^-1022 is the smallest number of full precision: it is there after 1022 halvings, and gone after one more.
        Track track(slowing(), 1 << 20);
        track.seek({1022, 0});
        QCOMPARE(track.state().velocityOf(1).x, least);
        track.seek({1023, 0});
        QCOMPARE(track.state().velocityOf(1).x, 0.0);
        QCOMPARE(track.state().velocityOf(1).y, 0.0);
        QVERIFY(countsTiny());
    }

    void noMethodLeavesTinyNumbers()
    {
        for (const std::string method : {"published", "semi_implicit_euler", "velocity_verlet"}) {
            support::Sample sample = support::sample("creature from one place");
            sample.values.set("damp", 0.6);
            Track track(support::script(sample, method), 1 << 20);
            for (int frame = 0; frame < 3000; ++frame) {
                track.seek({frame, 0});
                QVERIFY2(!hasTiny(track.state()), method.c_str());
            }
        }
    }

    void whoeverComputesItGetsTheSameBits()
    {
        const Script script = slowing();
        Track track(script, 1 << 20), bare(script, 0);
        for (const int frame : {1020, 1022, 1023, 1024, 1100}) {
            track.seek({frame, 0});
            const State state = track.state();
            QVERIFY(sameBits(support::plainRun(script.build({}), "semi_implicit_euler", 1.0, frame), state));
            QVERIFY(sameBits(track.stateAt(frame), state));
            bare.seek({frame, 0});
            QVERIFY(sameBits(bare.state(), state));
            bare.seek({0, 0});
            bare.seek({frame - 1, 1});
            bare.seek({frame, 0});
            QVERIFY(sameBits(bare.state(), state));
        }
    }

    void theNumbersBehindAMomentAreTheRuns()
    {
        Track track(slowing(), 1 << 20);
        track.seek({1023, 0});
        bool found = false;
        for (const PhaseExplanation &moment : track.explainPhases("body")) {
            for (const LiveValue &live : moment.live) {
                if (live.name != "v")
                    continue;
                QCOMPARE(std::get<Vec2>(live.value).x, 0.0);
                QCOMPARE(std::get<Vec2>(*live.before).x, least);
                found = true;
            }
        }
        QVERIFY(found);
    }

    void theBooksCloseOnTheRunsOwnState()
    {
        Track track(slowing(), 1 << 20);
        track.seek({1024, 0});
        Ledger ledger;
        const std::optional<Balance> row = ledger.row(track, 1023);
        QVERIFY(row);
        QCOMPARE(row->after.momentum.x, 0.0);
        QVERIFY(countsTiny());
    }
};

QTEST_APPLESS_MAIN(TestFlush)
#include "tst_flush_denormals.moc"
