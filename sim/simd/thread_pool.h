#pragma once

#include <functional>
#include <memory>

namespace sim {

/// A pool of threads that share a job with the calling thread. The threads start with the first job, sleep
/// between jobs, and end with the pool.
class ThreadPool
{
public:
    /// Uses two threads, or one if the machine has one processor.
    ThreadPool();
    /// Uses `threads` threads, including the calling one. Values below 1 count as 1, which starts no thread.
    explicit ThreadPool(int threads);
    /// Creates a pool with the same number of threads. A copy starts its own threads.
    ThreadPool(const ThreadPool &other);
    ThreadPool &operator=(const ThreadPool &other);
    ThreadPool(ThreadPool &&) noexcept;
    ThreadPool &operator=(ThreadPool &&) noexcept;
    ~ThreadPool();

    /// Calls `work(part)` for each part from 0 to `parts` - 1, on any thread and in any order. Returns when
    /// all calls have finished. The threads use the floating-point mode of the calling thread: its rounding,
    /// and whether it flushes denormals. `work` must not throw.
    void parallelFor(int parts, const std::function<void(int part)> &work);

private:
    class Workers;

    int m_threads;
    std::unique_ptr<Workers> m_workers; ///< null before the first job
};

}
