#include "sim/simd/thread_pool.h"

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

/// How often each of `parts` parts is called.
std::vector<int> callsOf(sim::ThreadPool &pool, int parts)
{
    std::vector<std::atomic<int>> calls(static_cast<std::size_t>(parts));
    pool.parallelFor(parts, [&](int part) { ++calls[static_cast<std::size_t>(part)]; });
    return {calls.begin(), calls.end()};
}

/// Shares a job of which no part ends before each of `threads` threads has one.
std::set<std::thread::id> meet(
    sim::ThreadPool &pool, int threads, const std::function<void()> &work = [] {})
{
    std::atomic<int> there = 0;
    std::vector<std::thread::id> who(static_cast<std::size_t>(threads));
    pool.parallelFor(threads, [&](int part) {
        ++there;
        while (there < threads)
            std::this_thread::yield();
        who[static_cast<std::size_t>(part)] = std::this_thread::get_id();
        work();
    });
    return {who.begin(), who.end()};
}

}

/// Workers that share the parts of a job.
class Crew : public QObject
{
    Q_OBJECT

    static void addThreadRows()
    {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3})
            QTest::addRow("%d threads", threads) << threads;
    }

private slots:
    void everyPartIsDoneOnce_data() { addThreadRows(); }
    void everyPartIsDoneOnce()
    {
        QFETCH(int, threads);
        sim::ThreadPool pool(threads);
        for (int job = 0; job < 300; ++job) {
            const int parts = job % 40;
            QCOMPARE(callsOf(pool, parts), std::vector<int>(static_cast<std::size_t>(parts), 1));
        }
    }

    void whenAJobIsOverAllThatItWroteIsThere_data() { addThreadRows(); }
    void whenAJobIsOverAllThatItWroteIsThere()
    {
        QFETCH(int, threads);
        sim::ThreadPool pool(threads);
        std::vector<int> numbers(1000, 0); // plain numbers: only the crew keeps its threads apart
        for (int job = 0; job < 200; ++job) {
            pool.parallelFor(1000, [&](int part) { numbers[static_cast<std::size_t>(part)] += part; });
            QCOMPARE(numbers[999], 999 * (job + 1));
            QCOMPARE(std::accumulate(numbers.begin(), numbers.end(), 0), 499'500 * (job + 1));
            std::fill(numbers.begin(), numbers.begin() + 10, 0);
            for (int i = 0; i < 10; ++i)
                numbers[static_cast<std::size_t>(i)] = i * (job + 1);
        }
    }

    void thePartsRunOnAsManyThreadsAsItHas_data() { addThreadRows(); }
    void thePartsRunOnAsManyThreadsAsItHas()
    {
        QFETCH(int, threads);
        sim::ThreadPool pool(threads);
        const std::set<std::thread::id> who = meet(pool, threads);
        QCOMPARE(who.size(), static_cast<std::size_t>(threads));
        QVERIFY(who.contains(std::this_thread::get_id()));
        QVERIFY(meet(pool, threads) == who); // the same ones for the next job
    }

    void aCopyHasThreadsOfItsOwnAndAMovedOneKeepsThem()
    {
        sim::ThreadPool pool(2);
        const std::set<std::thread::id> who = meet(pool, 2);
        sim::ThreadPool copy = pool;
        const std::set<std::thread::id> others = meet(copy, 2);
        QVERIFY(others != who);
        copy = pool;
        QCOMPARE(meet(copy, 2).size(), std::size_t{2});
        sim::ThreadPool moved = std::move(pool);
        QVERIFY(meet(moved, 2) == who);
        sim::ThreadPool unused(3); // ends without ever having started
        sim::ThreadPool another = unused;
        another = std::move(moved);
        QVERIFY(meet(another, 2) == who);
    }

    void helpersRoundAsTheirCallerDoes()
    {
        sim::ThreadPool pool(2);
        const double third = 1.0 / 3.0; // rounded down
        for (const bool upwards : {true, false, true}) {
            std::fesetround(upwards ? FE_UPWARD : FE_TONEAREST);
            std::atomic<int> asCaller = 0;
            meet(pool, 2, [&] {
                volatile double one = 1.0, three = 3.0;
                asCaller += (one / three > third) == upwards ? 1 : 0;
            });
            std::fesetround(FE_TONEAREST);
            QCOMPARE(asCaller.load(), 2);
        }
    }

    void helpersFlushWhatIsTooSmallIfTheirCallerDoes()
    {
#if defined(__SSE2__)
        sim::ThreadPool pool(2);
        for (const bool flushes : {false, true, false}) {
            _MM_SET_FLUSH_ZERO_MODE(flushes ? _MM_FLUSH_ZERO_ON : _MM_FLUSH_ZERO_OFF);
            _MM_SET_DENORMALS_ZERO_MODE(flushes ? _MM_DENORMALS_ZERO_ON : _MM_DENORMALS_ZERO_OFF);
            std::atomic<int> asCaller = 0;
            meet(pool, 2, [&] {
                volatile double least = std::numeric_limits<double>::min();
                volatile double denormal = std::numeric_limits<double>::denorm_min();
                const bool flushed = least / 4.0 == 0.0 && denormal * 1e300 == 0.0;
                asCaller += flushed == flushes ? 1 : 0;
            });
            _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
            _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_OFF);
            QCOMPARE(asCaller.load(), 2);
        }
#else
        QSKIP("no such mode here");
#endif
    }

    void betweenJobsHelpersSleep()
    {
        const QDir tasks(QStringLiteral("/proc/self/task"));
        if (!tasks.exists())
            QSKIP("no list of threads here");
        sim::ThreadPool pool(3);
        QCOMPARE(meet(pool, 3).size(), std::size_t{3});
        const auto sleeping = [&] {
            int count = 0;
            for (const QString &task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
                QFile stat(tasks.filePath(task + QStringLiteral("/stat")));
                if (stat.open(QIODevice::ReadOnly))
                    count += stat.readAll().contains(") S ") ? 1 : 0; // what spins is R
            }
            return count;
        };
        QTRY_VERIFY(sleeping() >= 2);
    }
};

QTEST_GUILESS_MAIN(Crew)
#include "tst_thread_pool.moc"
