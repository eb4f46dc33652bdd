#pragma once

#include <chrono>
#include <ctime>

namespace sim {

/// Returns the wall time in seconds since an arbitrary start.
inline double wallSeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the CPU time of this thread in seconds, which excludes the time that other programs take. Where
/// the system has no such clock, returns wallSeconds(). A call takes longer than reading the wall clock.
inline double threadCpuSeconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
    timespec time = {};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
    return wallSeconds();
}

}
