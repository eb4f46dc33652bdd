// Background jobs: what is delivered, in which order, and how they end.

#include "app/model/jobs/background_job.h"
#include "tests/suite.h"

#include <QThread>
#include <QtTest>

#include <atomic>
#include <optional>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace app;
using Context = BackgroundJob::Context;

namespace {

/// A result handler for work whose result does not matter.
constexpr auto ignore = [](std::future<void>) {};

/// Work that begins, and then runs until the test lets it end or, if it checks its context, until it is cancelled.
struct HeldWork
{
    std::binary_semaphore begun{0};
    std::atomic<bool> mayEnd = false;
    std::atomic<bool> hasEnded = false;
    std::atomic<bool> wasCancelled = false;

    /// Runs until it is cancelled or may end.
    auto cancellable()
    {
        return [this](const Context &job) {
            begun.release();
            while (!mayEnd && !job.isCancelled())
                std::this_thread::yield();
            wasCancelled = job.isCancelled();
            hasEnded = true;
        };
    }
    /// Runs until it may end, even if it is cancelled.
    auto stubborn()
    {
        return [this](const Context &) {
            begun.release();
            while (!mayEnd)
                std::this_thread::yield();
            hasEnded = true;
        };
    }
};

}

class TestBackgroundJob : public QObject
{
    Q_OBJECT

private slots:
    void theResultArrivesInTheThreadOfTheOwner()
    {
        BackgroundJob job;
        std::atomic<QThread *> workThread = nullptr;
        QThread *resultThread = nullptr;
        int result = 0;
        job.start(
            [&](const Context &) {
                workThread = QThread::currentThread();
                return 42;
            },
            [&](std::future<int> arrived) {
                result = arrived.get();
                resultThread = QThread::currentThread();
            });
        QVERIFY(job.isRunning());
        QTRY_COMPARE(result, 42);
        QVERIFY(!job.isRunning());
        QCOMPARE(resultThread, QThread::currentThread());
        QVERIFY(workThread != resultThread);
    }

    void aJobIsNotRunningAnyMoreWhenItsResultArrives()
    {
        BackgroundJob job;
        std::optional<bool> wasRunning;
        job.start([](const Context &) {}, [&](std::future<void>) { wasRunning = job.isRunning(); });
        QTRY_VERIFY(wasRunning.has_value());
        QVERIFY(!*wasRunning);
    }

    void reportsArriveInOrderAndBeforeTheResult()
    {
        BackgroundJob job;
        std::vector<int> arrived;
        std::vector<int> expected;
        for (int i = 0; i <= 1000; ++i)
            expected.push_back(i);
        job.start(
            [&](const Context &context) {
                for (int i = 0; i < 1000; ++i)
                    context.report([&arrived, i] { arrived.push_back(i); });
                return 1000;
            },
            [&](std::future<int> result) { arrived.push_back(result.get()); });
        QTRY_VERIFY(!job.isRunning());
        QCOMPARE(arrived, expected);
    }

    void reportsArriveWhileTheWorkGoesOn()
    {
        HeldWork held;
        bool hasArrived = false;
        BackgroundJob job;
        job.start(
            [&](const Context &context) {
                context.report([&] { hasArrived = true; });
                held.cancellable()(context);
            },
            ignore);
        QTRY_VERIFY(hasArrived);
        QVERIFY(job.isRunning());
        held.mayEnd = true;
        QTRY_VERIFY(!job.isRunning());
    }

    void resultsOfCancelledWorkNeverArriveEvenIfItHadFinished()
    {
        BackgroundJob job;
        int arrivals = 0;
        job.start([&](const Context &context) { context.report([&] { ++arrivals; }); },
                  [&](std::future<void>) { ++arrivals; });
        job.wait(); // both are on their way now
        job.cancel();
        QVERIFY(!job.isRunning());
        QCoreApplication::processEvents();
        QCOMPARE(arrivals, 0);
    }

    void onlyTheResultOfTheLastStartArrives()
    {
        BackgroundJob job;
        std::vector<int> arrived;
        for (int i = 0; i < 1000; ++i) {
            job.start([i](const Context &) { return i; },
                      [&](std::future<int> result) { arrived.push_back(result.get()); });
            if (i % 3 == 0)
                std::this_thread::yield();
        }
        QTRY_VERIFY(!job.isRunning());
        QCOMPARE(arrived, std::vector<int>{999});
    }

    void workLearnsThatItWasReplaced()
    {
        HeldWork held;
        BackgroundJob job;
        bool hasArrived = false;
        job.start(held.cancellable(), [&](std::future<void>) { hasArrived = true; });
        held.begun.acquire();
        bool wasCancelledBefore = false;
        job.start([&](const Context &context) { wasCancelledBefore = context.isCancelled(); }, ignore);
        QTRY_VERIFY(!job.isRunning());
        QVERIFY(held.wasCancelled);
        QVERIFY(!hasArrived);
        QVERIFY(!wasCancelledBefore); // the new work is not cancelled with the old
    }

    void computationsOfTheCoreLearnThatTheyWereCancelled()
    {
        std::binary_semaphore begun{0};
        std::atomic<bool> hasEnded = false;
        BackgroundJob job;
        job.start(
            [&](const Context &context) {
                const sim::ShouldContinue shouldContinue = context.shouldContinue();
                begun.release();
                while (shouldContinue())
                    std::this_thread::yield();
                hasEnded = true;
            },
            ignore);
        begun.acquire();
        job.cancel();
        job.wait();
        QVERIFY(hasEnded);
    }

    void cancellingDoesNotWaitForTheWork()
    {
        HeldWork held;
        BackgroundJob job;
        job.start(held.stubborn(), ignore);
        held.begun.acquire();
        job.cancel();
        const bool hadEnded = held.hasEnded;
        held.mayEnd = true;
        QVERIFY(!hadEnded);
        QVERIFY(!job.isRunning());
    }

    void destructionCancelsAndWaits()
    {
        HeldWork held;
        int arrivals = 0;
        {
            BackgroundJob job;
            job.start(
                [&](const Context &context) {
                    context.report([&] { ++arrivals; });
                    held.cancellable()(context);
                },
                [&](std::future<void>) { ++arrivals; });
            held.begun.acquire();
        }
        QVERIFY(held.hasEnded);
        QVERIFY(held.wasCancelled);
        QCoreApplication::processEvents();
        QCOMPARE(arrivals, 0);
    }

    void destructionDropsWorkThatHasNotBegun()
    {
        HeldWork held;
        const std::shared_ptr<QThreadPool> thread = makeJobThread();
        BackgroundJob busy(thread);
        busy.start(held.stubborn(), ignore);
        held.begun.acquire();
        bool hasBegun = false;
        {
            BackgroundJob waiting(thread);
            waiting.start([&](const Context &) { hasBegun = true; }, ignore);
        }
        const bool hadEnded = held.hasEnded;
        held.mayEnd = true;
        QVERIFY(!hadEnded); // it did not wait for the other job
        QTRY_VERIFY(!busy.isRunning());
        QVERIFY(!hasBegun);
    }

    void anExceptionArrivesInPlaceOfTheResult()
    {
        BackgroundJob job;
        QString error;
        job.start([](const Context &) -> int { throw std::runtime_error("no scene"); },
                  [&](std::future<int> result) {
                      try {
                          result.get();
                      } catch (const std::runtime_error &thrown) {
                          error = thrown.what();
                      }
                  });
        QTRY_COMPARE(error, QString("no scene"));
        int result = 0;
        job.start([](const Context &) { return 7; }, [&](std::future<int> next) { result = next.get(); });
        QTRY_COMPARE(result, 7);
    }

    void addedWorkRunsInOrderAndNoneIsLost()
    {
        BackgroundJob job;
        std::vector<int> ran; // by the thread
        std::vector<int> arrived;
        std::vector<int> expected;
        for (int i = 0; i < 1000; ++i) {
            expected.push_back(i);
            job.add(
                [&ran, i](const Context &) {
                    ran.push_back(i);
                    return i;
                },
                [&arrived](std::future<int> result) { arrived.push_back(result.get()); });
        }
        job.wait();
        QCOMPARE(ran, expected);
        QVERIFY(job.isRunning()); // the results are still on their way
        QTRY_VERIFY(!job.isRunning());
        QCOMPARE(arrived, expected);
    }

    void jobsThatShareAThreadNeverRunAtTheSameTime()
    {
        const std::shared_ptr<QThreadPool> thread = makeJobThread();
        BackgroundJob a(thread), b(thread);
        std::atomic<int> running = 0;
        std::atomic<int> most = 0;
        const auto work = [&](const Context &) {
            most = std::max(most.load(), ++running);
            std::this_thread::yield();
            --running;
        };
        for (int i = 0; i < 100; ++i) {
            a.add(work, ignore);
            b.add(work, ignore);
        }
        QTRY_VERIFY(!a.isRunning() && !b.isRunning());
        QCOMPARE(most.load(), 1);
    }

    void jobsWithTheirOwnThreadsDoNotWaitForEachOther()
    {
        HeldWork held;
        BackgroundJob busy, other;
        busy.start(held.stubborn(), ignore);
        held.begun.acquire();
        other.start([](const Context &) {}, ignore);
        const bool hasArrived = QTest::qWaitFor([&] { return !other.isRunning(); });
        const bool hadEnded = held.hasEnded;
        held.mayEnd = true;
        QVERIFY(hasArrived);
        QVERIFY(!hadEnded);
    }

    void aResultMayStartTheNextWork()
    {
        BackgroundJob job;
        int rounds = 0;
        const std::function<void()> next = [&] {
            job.start([](const Context &) {},
                      [&](std::future<void>) {
                          if (++rounds < 10)
                              next();
                      });
        };
        next();
        QTRY_COMPARE(rounds, 10);
        QVERIFY(!job.isRunning());
    }

    void aReportMayDestroyTheJob()
    {
        auto job = std::make_unique<BackgroundJob>();
        int arrivals = 0;
        job->start(
            [&](const Context &context) {
                context.report([&] {
                    ++arrivals;
                    job.reset();
                });
                context.report([&] { ++arrivals; });
            },
            [&](std::future<void>) { ++arrivals; });
        QTRY_VERIFY(!job);
        QCoreApplication::processEvents();
        QCOMPARE(arrivals, 1);
    }

    void workIsReleasedWhenItsResultHasArrived()
    {
        BackgroundJob job;
        const auto scene = std::make_shared<int>(1);
        job.start([scene](const Context &) {}, ignore);
        QTRY_VERIFY(!job.isRunning());
        QTRY_COMPARE(scene.use_count(), 1L);
    }
};

SUITE(tst_background_job, TestBackgroundJob)
#include "tst_background_job.moc"
