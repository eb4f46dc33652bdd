#include "sim/simd/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

namespace sim {

/// The helper threads and the current job. The members of a job are written only while no helper works on it.
class ThreadPool::Workers
{
public:
    explicit Workers(int threads) : m_shares(static_cast<std::size_t>(threads))
    {
        for (std::size_t i = 1; i < m_shares.size(); ++i)
            m_helpers.emplace_back([this, i] { helperLoop(i); });
    }

    ~Workers()
    {
        m_isStopping = true;
        m_jobNumber.fetch_add(1);
        m_jobNumber.notify_all();
        for (std::thread &helper : m_helpers)
            helper.join();
    }

    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    void parallelFor(int parts, const std::function<void(int)> &work)
    {
        m_work = &work;
        std::fegetenv(&m_floatingPointMode);
        const auto count = static_cast<int>(m_shares.size());
        for (int i = 0; i < count; ++i) {
            Share &share = m_shares[static_cast<std::size_t>(i)];
            share.next = static_cast<int>(std::int64_t{parts} * i / count);
            share.end = static_cast<int>(std::int64_t{parts} * (i + 1) / count);
        }
        m_activeHelpers.store(0); // lets helpers join
        m_jobNumber.fetch_add(1);
        m_jobNumber.notify_all();
        runParts(0);
        finishJob();
    }

private:
    /// The parts of a job that one thread starts with. A thread has the same share in each job, so its data
    /// stays in the cache of its processor. A thread that has finished its share continues with those of the
    /// others.
    struct alignas(64) Share
    {
        std::atomic<int> next = 0;
        int end = 0;
    };

    void runParts(std::size_t self)
    {
        for (std::size_t i = 0; i < m_shares.size(); ++i) {
            Share &share = m_shares[(self + i) % m_shares.size()];
            for (int part = share.next++; part < share.end; part = share.next++)
                (*m_work)(part);
        }
    }

    void helperLoop(std::size_t self)
    {
        unsigned seen = 0;
        for (;;) {
            waitForJob(seen);
            seen = m_jobNumber;
            if (m_isStopping)
                return;
            if (!joinJob())
                continue; // the job has finished already
            std::fesetenv(&m_floatingPointMode);
            runParts(self);
            if (m_activeHelpers.fetch_sub(1) - 1 == closedOffset)
                m_activeHelpers.notify_one();
        }
    }

    /// Waits for a job after the job `seen`. It spins for a while before it sleeps: in a running animation
    /// the next job comes soon, and waking a thread takes longer.
    void waitForJob(unsigned seen)
    {
        spinUntil([&] { return m_jobNumber != seen; });
        m_jobNumber.wait(seen);
    }

    /// Counts this helper as active. Returns false if the job has finished.
    bool joinJob()
    {
        int active = m_activeHelpers;
        while (active >= 0) {
            if (m_activeHelpers.compare_exchange_weak(active, active + 1))
                return true;
        }
        return false;
    }

    /// Stops helpers from joining, and waits for those that have joined. It does not wait for helpers that
    /// still sleep.
    void finishJob()
    {
        int active = m_activeHelpers.fetch_add(closedOffset) + closedOffset;
        spinUntil([&] { return (active = m_activeHelpers) == closedOffset; });
        for (; active != closedOffset; active = m_activeHelpers)
            m_activeHelpers.wait(active);
    }

    /// Spins until `condition()` is true, but at most for `spinTime`.
    template <class Condition>
    static void spinUntil(const Condition &condition)
    {
        const auto end = std::chrono::steady_clock::now() + spinTime;
        while (!condition() && std::chrono::steady_clock::now() < end)
            pause();
    }

    static void pause()
    {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#endif
    }

    /// Added to the number of active helpers, it makes the number negative.
    static constexpr int closedOffset = std::numeric_limits<int>::min() / 2;
    /// About as long as waking a thread takes in a virtual machine, and much shorter than the time between
    /// two frames. It is a time and not a number of pauses, because processors differ by a factor of ten in
    /// the length of a pause.
    static constexpr std::chrono::microseconds spinTime{100};

    std::vector<Share> m_shares; ///< one per thread, the calling thread first
    const std::function<void(int)> *m_work = nullptr;
    std::fenv_t m_floatingPointMode{};
    /// The number of helpers that work on the job, plus `closedOffset` if no more may join.
    std::atomic<int> m_activeHelpers = closedOffset;
    std::atomic<unsigned> m_jobNumber = 0; ///< increases by one with each job
    std::atomic<bool> m_isStopping = false;
    std::vector<std::thread> m_helpers;
};

ThreadPool::ThreadPool() : ThreadPool(std::thread::hardware_concurrency() > 1 ? 2 : 1) {}

ThreadPool::ThreadPool(int threads) : m_threads(std::max(1, threads)) {}

ThreadPool::ThreadPool(const ThreadPool &other) : ThreadPool(other.m_threads) {}

ThreadPool &ThreadPool::operator=(const ThreadPool &other)
{
    m_threads = other.m_threads;
    m_workers.reset();
    return *this;
}

ThreadPool::ThreadPool(ThreadPool &&) noexcept = default;
ThreadPool &ThreadPool::operator=(ThreadPool &&) noexcept = default;
ThreadPool::~ThreadPool() = default;

void ThreadPool::parallelFor(int parts, const std::function<void(int)> &work)
{
    if (m_threads == 1 || parts < 2) {
        for (int i = 0; i < parts; ++i)
            work(i);
        return;
    }
    if (!m_workers)
        m_workers = std::make_unique<Workers>(m_threads);
    m_workers->parallelFor(parts, work);
}

}
