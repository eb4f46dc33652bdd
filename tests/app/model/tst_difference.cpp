// How far two runs are apart, against sums in closed form.

#include "tests/app/model/branches_support.h"

#include "app/model/series/difference_series.h"
#include "app/model/text/difference_text.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;
using branches_support::World;

namespace {

/// Two falls part at `fork` with another `gravity`: the distance at `frame`. Every number here is exact in binary.
double apart(double gravity, std::int64_t fork, std::int64_t frame)
{
    const auto n = static_cast<double>(frame - fork);
    return frame <= fork ? 0.0 : std::abs(gravity) * n * (n + 1.0) / 2.0;
}

}

class DifferenceTest : public QObject
{
    Q_OBJECT

private slots:
    void distanceOfTwoFallsMatchesTheClosedForm_data()
    {
        QTest::addColumn<int>("fork");
        QTest::addColumn<double>("gravity");
        QTest::newRow("from the start") << 0 << 0.75;
        QTest::newRow("from frame 30") << 30 << 0.75;
        QTest::newRow("upwards") << 17 << 0.125;
    }

    void distanceOfTwoFallsMatchesTheClosedForm()
    {
        QFETCH(int, fork);
        QFETCH(double, gravity);
        World world;
        world.fork(60, fork, "gravity", gravity);
        world.session.playback().goTo({60, 0});
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        series.setActive(true);
        QTRY_VERIFY(series.next() > series.end());
        QCOMPARE(series.shared(), fork);
        QCOMPARE(series.samples().size(), std::size_t(61 - fork));
        for (const Difference &one : series.samples()) {
            QCOMPARE(one.distance, apart(gravity - 0.5, fork, one.frame));
            QVERIFY(one.frame == fork || one.body == "foot");
        }
        QCOMPARE(series.largest()->frame, 60);
        QCOMPARE(series.largest()->distance, apart(gravity - 0.5, fork, 60));
        QVERIFY(differenceSentence(series).contains("foot, at frame 60"));
    }

    void theChosenBodyIsComparedAlone()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.playback().goTo({60, 0});
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        series.setActive(true);
        series.setOf(DifferenceSeries::Of::selected);
        world.session.select("body"); // it stands still in both
        QTRY_VERIFY(series.next() > series.end());
        QCOMPARE(series.largest()->distance, 0.0);
        QVERIFY(differenceSentence(series).startsWith("No difference"));
        world.session.select("foot");
        QTRY_VERIFY(series.next() > series.end());
        QCOMPARE(series.largest()->distance, apart(0.25, 30, 60));
    }

    void seriesGrowsWithTheRunAndFollowsChanges()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        series.setActive(true);
        for (int frame = 31; frame <= 40; ++frame) {
            world.session.playback().frameForward();
            QCOMPARE(series.samples().back().frame, frame);
        }
        world.session.editor().setParameter("gravity", 1.0); // at the end of the run: the same two go on
        world.session.playback().goTo({50, 0});
        QTRY_VERIFY(series.next() > series.end());
        const double there = apart(0.25, 30, 40), speed = 0.25 * 10;
        QCOMPARE(series.largest()->distance, there + speed * 10 + apart(0.5, 40, 50));
        world.session.editor().goBackTo(world.session.comparisons().shown()->id);
        world.session.playback().goTo({50, 0});
        QTRY_VERIFY(series.next() > series.end());
        QCOMPARE(series.largest()->distance, there + speed * 10 + apart(0.5, 40, 50));
    }

    void theLargestNeedNotBeTheLast()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.playback().goTo({40, 0});
        world.session.editor().setParameter("gravity", 0.125); // it falls back, meets the other and passes it
        world.session.playback().goTo({52, 0});
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        series.setActive(true);
        QTRY_VERIFY(series.next() > series.end());
        double most = 0.0;
        std::int64_t where = 0;
        for (std::int64_t frame = 30; frame <= 52; ++frame) {
            const double m = static_cast<double>(std::max<std::int64_t>(0, frame - 40));
            const double now = std::abs(apart(0.25, 30, std::min<std::int64_t>(frame, 40)) + 2.5 * m -
                                        0.375 * m * (m + 1) / 2);
            if (now > most) {
                most = now;
                where = frame;
            }
        }
        QVERIFY(where > 40 && where < 52);
        QCOMPARE(series.largest()->distance, most);
        QCOMPARE(series.largest()->frame, where);
    }

    void runsWithOtherStepsMeetAtTheFramesThatBothHave()
    {
        World world;
        world.session.playback().goTo({60, 0});
        world.session.playback().goTo({0, 0});
        world.session.editor().setStepSize(4.0);
        world.session.playback().goTo({60, 0});
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        series.setActive(true);
        QTRY_VERIFY(series.next() > series.end());
        QCOMPARE(series.samples().size(), std::size_t(16));
        // After m steps of 4 frames: 16 g m (m + 1) / 2; after n = 4 m of one: g n (n + 1) / 2.
        for (const Difference &one : series.samples()) {
            const double n = static_cast<double>(one.frame), m = n / 4;
            QCOMPARE(one.distance, 0.5 * (16 * m * (m + 1) / 2 - n * (n + 1) / 2));
        }
    }

    void longRunsAreThinned()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.playback().goTo({20'000, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!world.session.playback().goal(), 20'000);
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        series.setActive(true);
        QTRY_VERIFY_WITH_TIMEOUT(series.next() > series.end(), 20'000);
        QVERIFY(series.samples().size() < DifferenceSeries::mostSamples);
        QVERIFY(series.spacing() > 1);
        QVERIFY(series.samples().back().frame + series.spacing() > 20'000); // none is missing at the end
        for (std::size_t i = 0; i < series.samples().size(); ++i)
            QCOMPARE(series.samples()[i].frame, 30 + static_cast<std::int64_t>(i) * series.spacing());
        QCOMPARE(series.largest()->distance, apart(0.25, 30, series.largest()->frame));
        QVERIFY(differenceSentence(series).contains("every"));
    }

    void inactiveSeriesReadsNothing()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        DifferenceSeries series(world.session.run(), world.session.comparisons());
        world.session.playback().goTo({60, 0});
        QVERIFY(series.samples().empty());
        series.setActive(true);
        QVERIFY(!series.samples().empty());
        world.session.comparisons().show(0);
        QVERIFY(series.samples().empty());
        QVERIFY(differenceSentence(series).startsWith("There is no other run"));
    }
};

SUITE(tst_difference, DifferenceTest)
#include "tst_difference.moc"
