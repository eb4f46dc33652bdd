#include "sim/simd/thread_pool.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <atomic>
#include <cfenv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace {

/// Returns how often each of `parts` parts is called.
std::vector<int> callsOf(sim::ThreadPool &pool, int parts)
{
    std::vector<std::atomic<int>> calls(static_cast<std::size_t>(parts));
    pool.parallelFor(parts, [&](int part) { ++calls[static_cast<std::size_t>(part)]; });
    return {calls.begin(), calls.end()};
}

/// Runs a job with one part per thread. No part ends before all have started. Returns the ids of the threads.
std::set<std::thread::id> runOnAllThreads(
    sim::ThreadPool &pool, int threads, const std::function<void()> &work = [] {})
{
    std::atomic<int> started = 0;
    std::vector<std::thread::id> ids(static_cast<std::size_t>(threads));
    pool.parallelFor(threads, [&](int part) {
        ++started;
        while (started < threads)
            std::this_thread::yield();
        ids[static_cast<std::size_t>(part)] = std::this_thread::get_id();
        work();
    });
    return {ids.begin(), ids.end()};
}

}

/// A pool of threads that share the parts of a job.
class TestThreadPool : public QObject
{
    Q_OBJECT

    static void addThreadRows()
    {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3})
            QTest::addRow("%d threads", threads) << threads;
    }

private slots:
    void everyPartRunsOnce_data() { addThreadRows(); }
    void everyPartRunsOnce()
    {
        QFETCH(int, threads);
        sim::ThreadPool pool(threads);
        for (int job = 0; job < 300; ++job) {
            const int parts = job % 40;
            QCOMPARE(callsOf(pool, parts), std::vector<int>(static_cast<std::size_t>(parts), 1));
        }
    }

    void resultsAreVisibleAfterTheJob_data() { addThreadRows(); }
    void resultsAreVisibleAfterTheJob()
    {
        QFETCH(int, threads);
        sim::ThreadPool pool(threads);
        std::vector<int> numbers(1000, 0); // not atomic, so the pool must order the accesses
        for (int job = 0; job < 200; ++job) {
            pool.parallelFor(1000, [&](int part) { numbers[static_cast<std::size_t>(part)] += part; });
            QCOMPARE(numbers[999], 999 * (job + 1));
            QCOMPARE(std::accumulate(numbers.begin(), numbers.end(), 0), 499'500 * (job + 1));
            std::fill(numbers.begin(), numbers.begin() + 10, 0);
            for (int i = 0; i < 10; ++i)
                numbers[static_cast<std::size_t>(i)] = i * (job + 1);
        }
    }

    void partsRunOnAllThreads_data() { addThreadRows(); }
    void partsRunOnAllThreads()
    {
        QFETCH(int, threads);
        sim::ThreadPool pool(threads);
        const std::set<std::thread::id> ids = runOnAllThreads(pool, threads);
        QCOMPARE(ids.size(), static_cast<std::size_t>(threads));
        QVERIFY(ids.contains(std::this_thread::get_id()));
        QVERIFY(runOnAllThreads(pool, threads) == ids); // the next job uses the same threads
    }

    void copyGetsNewThreadsAndMoveKeepsThem()
    {
        sim::ThreadPool pool(2);
        const std::set<std::thread::id> ids = runOnAllThreads(pool, 2);
        sim::ThreadPool copy = pool;
        const std::set<std::thread::id> otherIds = runOnAllThreads(copy, 2);
        QVERIFY(otherIds != ids);
        copy = pool;
        QCOMPARE(runOnAllThreads(copy, 2).size(), std::size_t{2});
        sim::ThreadPool moved = std::move(pool);
        QVERIFY(runOnAllThreads(moved, 2) == ids);
        sim::ThreadPool unused(3); // destroyed without ever having started its threads
        sim::ThreadPool another = unused;
        another = std::move(moved);
        QVERIFY(runOnAllThreads(another, 2) == ids);
    }

    void workersUseTheRoundingModeOfTheCaller()
    {
        sim::ThreadPool pool(2);
        const double third = 1.0 / 3.0; // rounded down
        for (const bool roundsUp : {true, false, true}) {
            std::fesetround(roundsUp ? FE_UPWARD : FE_TONEAREST);
            std::atomic<int> asCaller = 0;
            runOnAllThreads(pool, 2, [&] {
                volatile double one = 1.0, three = 3.0;
                asCaller += (one / three > third) == roundsUp ? 1 : 0;
            });
            std::fesetround(FE_TONEAREST);
            QCOMPARE(asCaller.load(), 2);
        }
    }

    void workersUseTheFlushModeOfTheCaller()
    {
#if defined(__SSE2__)
        sim::ThreadPool pool(2);
        for (const bool flushes : {false, true, false}) {
            _MM_SET_FLUSH_ZERO_MODE(flushes ? _MM_FLUSH_ZERO_ON : _MM_FLUSH_ZERO_OFF);
            _MM_SET_DENORMALS_ZERO_MODE(flushes ? _MM_DENORMALS_ZERO_ON : _MM_DENORMALS_ZERO_OFF);
            std::atomic<int> asCaller = 0;
            runOnAllThreads(pool, 2, [&] {
                volatile double leastNormal = std::numeric_limits<double>::min();
                volatile double denormal = std::numeric_limits<double>::denorm_min();
                const bool isFlushed = leastNormal / 4.0 == 0.0 && denormal * 1e300 == 0.0;
                asCaller += isFlushed == flushes ? 1 : 0;
            });
            _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
            _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_OFF);
            QCOMPARE(asCaller.load(), 2);
        }
#else
        QSKIP("no such mode here");
#endif
    }

    void workersSleepBetweenJobs()
    {
        const QDir tasks(QStringLiteral("/proc/self/task"));
        if (!tasks.exists())
            QSKIP("no list of threads here");
        sim::ThreadPool pool(3);
        QCOMPARE(runOnAllThreads(pool, 3).size(), std::size_t{3});
        const auto sleeping = [&] {
            int count = 0;
            for (const QString &task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
                QFile stat(tasks.filePath(task + QStringLiteral("/stat")));
                if (stat.open(QIODevice::ReadOnly))
                    count += stat.readAll().contains(") S ") ? 1 : 0; // a spinning thread has state R
            }
            return count;
        };
        QTRY_VERIFY(sleeping() >= 2);
    }
};

SUITE(tst_thread_pool, TestThreadPool)
#include "tst_thread_pool.moc"
