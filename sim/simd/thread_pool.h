#pragma once

#include <functional>
#include <memory>

namespace sim {

/// Workers that share the parts of a job with the thread that has it. They are started with the first job, sleep
/// between two jobs, and end with the crew.
class ThreadPool
{
public:
    /// Two threads; one where the machine has no second processor.
    ThreadPool();
    /// `threads`: how many compute, the calling one included; at least 1. 1 starts none.
    explicit ThreadPool(int threads);
    /// A crew of as many threads, which starts its own.
    ThreadPool(const ThreadPool &other);
    ThreadPool &operator=(const ThreadPool &other);
    ThreadPool(ThreadPool &&) noexcept;
    ThreadPool &operator=(ThreadPool &&) noexcept;
    ~ThreadPool();

    /// Calls `work(part)` for each part from 0 to `parts` - 1, on any of the threads and in any order, and returns when
    /// all are done. The threads compute in the calling one's floating-point mode: how it rounds, and whether it flushes
    /// what is too small to 0. `work` must not throw.
    void parallelFor(int parts, const std::function<void(int part)> &work);

private:
    class Workers;

    int m_threads;
    std::unique_ptr<Workers> m_running; ///< null before the first job
};

}
