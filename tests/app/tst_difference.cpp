// How far two runs are apart, against sums in closed form.

#include "branches_bench.h"

#include "app/model/difference_course.h"
#include "app/model/difference_words.h"

#include <QtTest>

using namespace app;
using branches_bench::World;

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
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }

    void twoFallsPartAsTheSumSays_data()
    {
        QTest::addColumn<int>("fork");
        QTest::addColumn<double>("gravity");
        QTest::newRow("from the start") << 0 << 0.75;
        QTest::newRow("from frame 30") << 30 << 0.75;
        QTest::newRow("upwards") << 17 << 0.125;
    }

    void twoFallsPartAsTheSumSays()
    {
        QFETCH(int, fork);
        QFETCH(double, gravity);
        World world;
        world.fork(60, fork, "gravity", gravity);
        world.session.goTo({60, 0});
        DifferenceCourse course(world.session);
        course.setWatched(true);
        QTRY_VERIFY(course.next() > course.end());
        QCOMPARE(course.shared(), fork);
        QCOMPARE(course.samples().size(), std::size_t(61 - fork));
        for (const Difference &one : course.samples()) {
            QCOMPARE(one.distance, apart(gravity - 0.5, fork, one.frame));
            QVERIFY(one.frame == fork || one.body == "foot");
        }
        QCOMPARE(course.largest()->frame, 60);
        QCOMPARE(course.largest()->distance, apart(gravity - 0.5, fork, 60));
        QVERIFY(differenceSentence(course).contains("foot, at frame 60"));
    }

    void theChosenBodyIsComparedAlone()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.goTo({60, 0});
        DifferenceCourse course(world.session);
        course.setWatched(true);
        course.setOf(DifferenceCourse::Of::selected);
        world.session.select("body"); // it stands still in both
        QTRY_VERIFY(course.next() > course.end());
        QCOMPARE(course.largest()->distance, 0.0);
        QVERIFY(differenceSentence(course).startsWith("No difference"));
        world.session.select("foot");
        QTRY_VERIFY(course.next() > course.end());
        QCOMPARE(course.largest()->distance, apart(0.25, 30, 60));
    }

    void itGrowsWithTheRunAndForgetsWhatChanged()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        DifferenceCourse course(world.session);
        course.setWatched(true);
        for (int frame = 31; frame <= 40; ++frame) {
            world.session.frameForward();
            QCOMPARE(course.samples().back().frame, frame);
        }
        world.session.setParameter("gravity", 1.0); // at the end of the run: the same two go on
        world.session.goTo({50, 0});
        QTRY_VERIFY(course.next() > course.end());
        const double there = apart(0.25, 30, 40), speed = 0.25 * 10;
        QCOMPARE(course.largest()->distance, there + speed * 10 + apart(0.5, 40, 50));
        world.session.goBackTo(world.session.beside()->id);
        world.session.goTo({50, 0});
        QTRY_VERIFY(course.next() > course.end());
        QCOMPARE(course.largest()->distance, there + speed * 10 + apart(0.5, 40, 50));
    }

    void theLargestNeedNotBeTheLast()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.goTo({40, 0});
        world.session.setParameter("gravity", 0.125); // it falls back, meets the other and passes it
        world.session.goTo({52, 0});
        DifferenceCourse course(world.session);
        course.setWatched(true);
        QTRY_VERIFY(course.next() > course.end());
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
        QCOMPARE(course.largest()->distance, most);
        QCOMPARE(course.largest()->frame, where);
    }

    void runsWithOtherStepsMeetAtTheFramesThatBothHave()
    {
        World world;
        world.session.goTo({60, 0});
        world.session.goTo({0, 0});
        world.session.setStepSize(4.0);
        world.session.goTo({60, 0});
        DifferenceCourse course(world.session);
        course.setWatched(true);
        QTRY_VERIFY(course.next() > course.end());
        QCOMPARE(course.samples().size(), std::size_t(16));
        // After m steps of 4 frames: 16 g m (m + 1) / 2; after n = 4 m of one: g n (n + 1) / 2.
        for (const Difference &one : course.samples()) {
            const double n = static_cast<double>(one.frame), m = n / 4;
            QCOMPARE(one.distance, 0.5 * (16 * m * (m + 1) / 2 - n * (n + 1) / 2));
        }
    }

    void longRunsAreThinned()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.goTo({20'000, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!world.session.goingTo(), 20'000);
        DifferenceCourse course(world.session);
        course.setWatched(true);
        QTRY_VERIFY_WITH_TIMEOUT(course.next() > course.end(), 20'000);
        QVERIFY(course.samples().size() < DifferenceCourse::mostSamples);
        QVERIFY(course.spacing() > 1);
        for (std::size_t i = 0; i < course.samples().size(); ++i)
            QCOMPARE(course.samples()[i].frame, 30 + static_cast<std::int64_t>(i) * course.spacing());
        QCOMPARE(course.largest()->distance, apart(0.25, 30, course.largest()->frame));
        QVERIFY(differenceSentence(course).contains("every"));
    }

    void nothingIsLookedAtWhileNobodyWatches()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        DifferenceCourse course(world.session);
        world.session.goTo({60, 0});
        QVERIFY(course.samples().empty());
        course.setWatched(true);
        QVERIFY(!course.samples().empty());
        world.session.showBeside(0);
        QVERIFY(course.samples().empty());
        QVERIFY(differenceSentence(course).startsWith("There is no other run"));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(DifferenceTest)
#include "tst_difference.moc"
