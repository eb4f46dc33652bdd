#pragma once

#include <chrono>
#include <ctime>

namespace sim {

/// Seconds that this thread has computed, where the system tells: other programs that come in between do not count.
/// Elsewhere the time that passes. Asking takes longer than reading a plain clock.
inline double threadCpuSeconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
    timespec time = {};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds that pass.
inline double wallSeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}
