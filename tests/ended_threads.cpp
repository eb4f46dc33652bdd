#include <chrono>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <thread>

namespace {

/// In sanitized suites: at the end waits, 100 ms at most, until this thread is the only one. Qt Test's watchdog may then
/// still be letting go of its `QThreadData`, which leak detection would take for lost.
struct WaitForThreads
{
    WaitForThreads() = default;
    WaitForThreads(const WaitForThreads &) = delete;
    WaitForThreads &operator=(const WaitForThreads &) = delete;
    ~WaitForThreads()
    {
        std::error_code error;
        for (int tries = 0; tries < 100; ++tries) {
            std::filesystem::directory_iterator tasks("/proc/self/task", error);
            if (error || std::distance(begin(tasks), end(tasks)) <= 1)
                return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
};

const WaitForThreads waitForThreads;

}
