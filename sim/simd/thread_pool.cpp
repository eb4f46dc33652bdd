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

/// Helpers that wait for jobs. All that they share is written while no helper is inside a job.
class ThreadPool::Workers
{
public:
    explicit Workers(int threads) : m_portions(static_cast<std::size_t>(threads))
    {
        for (std::size_t i = 1; i < m_portions.size(); ++i)
            m_helpers.emplace_back([this, i] { help(i); });
    }

    ~Workers()
    {
        m_ends = true;
        m_job.fetch_add(1);
        m_job.notify_all();
        for (std::thread &helper : m_helpers)
            helper.join();
    }

    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    void parallelFor(int parts, const std::function<void(int)> &work)
    {
        m_work = &work;
        std::fegetenv(&m_mode);
        const auto count = static_cast<int>(m_portions.size());
        for (int i = 0; i < count; ++i) {
            Range &portion = m_portions[static_cast<std::size_t>(i)];
            portion.next = static_cast<int>(std::int64_t{parts} * i / count);
            portion.end = static_cast<int>(std::int64_t{parts} * (i + 1) / count);
        }
        m_inside.store(0); // the gate is open
        m_job.fetch_add(1);
        m_job.notify_all();
        take(0);
        close();
    }

private:
    /// The parts of a job that one thread begins with. The same ones in each job, so that what it computes stays in
    /// its processor's cache; whoever is done takes from the others.
    struct alignas(64) Range
    {
        std::atomic<int> next = 0;
        int end = 0;
    };

    void take(std::size_t self)
    {
        for (std::size_t i = 0; i < m_portions.size(); ++i) {
            Range &portion = m_portions[(self + i) % m_portions.size()];
            for (int part = portion.next++; part < portion.end; part = portion.next++)
                (*m_work)(part);
        }
    }

    void help(std::size_t self)
    {
        unsigned seen = 0;
        for (;;) {
            waitForJob(seen);
            seen = m_job;
            if (m_ends)
                return;
            if (!enter())
                continue; // too late: it is done
            std::fesetenv(&m_mode);
            take(self);
            if (m_inside.fetch_sub(1) - 1 == closed)
                m_inside.notify_one();
        }
    }

    /// Looks again for a while before it sleeps: while frames follow each other, the next job comes soon, and to be
    /// woken takes longer than that.
    void waitForJob(unsigned seen)
    {
        lookUntil([&] { return m_job != seen; });
        m_job.wait(seen);
    }

    bool enter()
    {
        int inside = m_inside;
        while (inside >= 0) {
            if (m_inside.compare_exchange_weak(inside, inside + 1))
                return true;
        }
        return false;
    }

    /// Lets nobody in any more, and waits until all are out. Who has not woken up yet is not waited for.
    void close()
    {
        int inside = m_inside.fetch_add(closed) + closed;
        lookUntil([&] { return (inside = m_inside) == closed; });
        for (; inside != closed; inside = m_inside)
            m_inside.wait(inside);
    }

    /// Asks `isSo` again and again until it is, for `patience` at most.
    template <class Ask>
    static void lookUntil(const Ask &isSo)
    {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!isSo() && std::chrono::steady_clock::now() < end)
            pause();
    }

    static void pause()
    {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#endif
    }

    static constexpr int closed = std::numeric_limits<int>::min() / 2;
    /// By the clock: what a processor takes for a pause differs by a factor of ten. About what it takes to be woken in a
    /// virtual machine, and next to nothing of the time between two pictures.
    static constexpr std::chrono::microseconds patience{100};

    std::vector<Range> m_portions; ///< one a thread, the calling one first
    const std::function<void(int)> *m_work = nullptr;
    std::fenv_t m_mode{};
    std::atomic<int> m_inside = closed; ///< helpers in a job; that plus `closed` when no more may come in
    std::atomic<unsigned> m_job = 0;    ///< goes up by one with each
    std::atomic<bool> m_ends = false;
    std::vector<std::thread> m_helpers;
};

ThreadPool::ThreadPool() : ThreadPool(std::thread::hardware_concurrency() > 1 ? 2 : 1) {}

ThreadPool::ThreadPool(int threads) : m_threads(std::max(1, threads)) {}

ThreadPool::ThreadPool(const ThreadPool &other) : ThreadPool(other.m_threads) {}

ThreadPool &ThreadPool::operator=(const ThreadPool &other)
{
    m_threads = other.m_threads;
    m_running.reset();
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
    if (!m_running)
        m_running = std::make_unique<Workers>(m_threads);
    m_running->parallelFor(parts, work);
}

}
