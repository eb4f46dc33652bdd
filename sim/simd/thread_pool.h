#pragma once

#include <functional>
#include <memory>

namespace sim {

/// Threads that share the parts of a job with the thread that has it. They are started with the first job, sleep
/// between two jobs, and end with the crew.
class Crew
{
public:
    /// Two threads; one where the machine has no second processor.
    Crew();
    /// `threads`: how many compute, the calling one included; at least 1. 1 starts none.
    explicit Crew(int threads);
    /// A crew of as many threads, which starts its own.
    Crew(const Crew &other);
    Crew &operator=(const Crew &other);
    Crew(Crew &&) noexcept;
    Crew &operator=(Crew &&) noexcept;
    ~Crew();

    /// Calls `work(part)` for each part from 0 to `parts` - 1, on any of the threads and in any order, and returns when
    /// all are done. The threads compute in the calling one's floating-point mode: how it rounds, and whether it flushes
    /// what is too small to 0. `work` must not throw.
    void share(int parts, const std::function<void(int part)> &work);

private:
    class Threads;

    int m_threads;
    std::unique_ptr<Threads> m_running; ///< null before the first job
};

}
