// The memory that keyframes take.

#include "tests/sim/support/support.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

Script stableCreature(double h = 1.0)
{
    support::Sample sample = support::sample("creature in a room");
    sample.values.set("k", 0.02); // stable at every step used here
    return support::script(sample, "semi_implicit_euler", h);
}

std::size_t startBytes()
{
    return Track(stableCreature(), 0).keyframeBytes();
}

}

class TestKeyframes : public QObject
{
    Q_OBJECT

private slots:
    void theBudgetIsNeverExceeded_data()
    {
        QTest::addColumn<int>("budget");
        QTest::addColumn<double>("h");
        for (const int budget : {2000, 5000, 20'000, 300'000}) {
            for (const double h : {0.5, 1.0, 3.0})
                QTest::addRow("%d bytes, h = %g", budget, h) << budget << h;
        }
    }
    void theBudgetIsNeverExceeded()
    {
        QFETCH(int, budget);
        QFETCH(double, h);
        const auto limit = std::size_t(budget);
        Track track(stableCreature(h), limit);
        for (int step = 0; step < 2000; ++step) {
            track.seek({track.cursor().frame + track.framesPerOutput(), 0});
            QVERIFY(track.keyframeBytes() <= limit);
        }
        support::Dice dice(1);
        for (int i = 0; i < 200; ++i) {
            track.seek({dice.whole(0, 2000), dice.whole(0, 20)});
            QVERIFY(track.keyframeBytes() <= limit);
        }
    }

    void keyframeSpacingDoublesWhenTheBudgetIsFull()
    {
        // The budget fits 8 states. The spacing is the smallest power of two with which the keyframes fit.
        const std::size_t stateBytes = startBytes();
        Track track(stableCreature(), 8 * stateBytes);
        for (int steps = 1; steps <= 300; ++steps) {
            track.seek({steps, 0});
            int spacing = 1;
            while (steps / spacing + 1 > 8)
                spacing *= 2;
            QCOMPARE(track.keyframeCount(), std::size_t(steps / spacing + 1));
            QCOMPARE(track.keyframeBytes(), track.keyframeCount() * stateBytes);
        }
    }

    void everyFrameOfTenMinutesFitsTheDefaultBudget()
    {
        // Without sleeping, because a run at rest keeps fewer states.
        Track track(stableCreature(), Timeline::defaultBudget / 2, Sleeping::never);
        track.seek({18'000, 0});
        QCOMPARE(track.keyframeCount(), std::size_t(18'001));
        QVERIFY(track.keyframeBytes() < Timeline::defaultBudget / 8);
    }

    void onlyTheStartIsKeptWithoutABudget()
    {
        Track track(stableCreature(), 0);
        track.seek({500, 0});
        track.seek({20, 3});
        QCOMPARE(track.keyframeCount(), std::size_t(1));
    }

    void smallerBudgetDropsKeyframes()
    {
        Track track(stableCreature(), 1'000'000);
        track.seek({1000, 0});
        track.setBudget(10'000);
        QVERIFY(track.keyframeBytes() <= 10'000);
        QVERIFY(track.keyframeCount() > 1);
        track.seek({2000, 0});
        QVERIFY(track.keyframeBytes() <= 10'000);
    }

    void runAndComparisonRunShareTheBudget()
    {
        constexpr std::size_t budget = 60'000;
        Timeline timeline(stableCreature(), budget);
        support::Dice dice(2);
        for (int round = 0; round < 20; ++round) {
            timeline.seek({timeline.cursor().frame + dice.whole(1, 300), 0});
            timeline.seek({dice.whole(1, int(timeline.cursor().frame)), 0});
            timeline.setParameter("k", dice.real(0.05, 0.3));
            QVERIFY(timeline.keyframeBytes() <= budget);
            QVERIFY(timeline.comparison());
        }
        timeline.dropComparison();
        QVERIFY(timeline.keyframeBytes() <= budget / 2);
    }

    void editDropsLaterKeyframes()
    {
        Timeline timeline(stableCreature());
        timeline.seek({100, 0});
        timeline.dropComparison();
        timeline.seek({40, 0});
        timeline.setParameter("k", 0.1);
        timeline.dropComparison();
        QCOMPARE(timeline.track().keyframeCount(), std::size_t(41)); // 0 to 40
        QCOMPARE(timeline.computed(), std::int64_t(40));
        QCOMPARE(timeline.keyframeBytes(), 41 * startBytes());
    }
};

SUITE(tst_keyframes, TestKeyframes)
#include "tst_keyframes.moc"
