#include "app/cli/terminal.h"

#include "app/model/text/quoting.h"

#include <QCoreApplication>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <unistd.h>

namespace app {

namespace {

struct TerminalText
{
    Q_DECLARE_TR_FUNCTIONS(TerminalText)
};

/// The message of printNoMemory(), made while there is memory.
QByteArray noMemory;

/// Returns whether the current exception reports that there is no memory, or none for another thread.
bool isWithoutMemory()
{
    try {
        if (std::current_exception())
            throw;
    } catch (const std::bad_alloc &) {
        return true;
    } catch (const std::system_error &error) {
        return error.code() == std::errc::resource_unavailable_try_again ||
               error.code() == std::errc::not_enough_memory;
    } catch (...) {
        return false;
    }
    return false;
}

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

}

void printMessage(const QString &sentence)
{
    std::fprintf(stderr, "%s\n", escaped(sentence).toUtf8().constData());
}

int printInterrupted()
{
    printMessage(TerminalText::tr("Stopped before the end."));
    return exitInterrupted;
}

int printInterrupted(std::int64_t frame, std::int64_t last)
{
    printMessage(TerminalText::tr("Stopped at frame %1 of %2.").arg(frame).arg(last));
    return exitInterrupted;
}

int printNoMemory()
{
    [[maybe_unused]] const ssize_t written = // allocates no memory
        ::write(STDERR_FILENO, noMemory.constData(), static_cast<std::size_t>(noMemory.size()));
    return exitBadUse;
}

void handleOutOfMemory()
{
    noMemory =
        TerminalText::tr(
            "springstep: there is not enough memory for this; close other programs, or give it a smaller "
            "experiment.")
            .toUtf8() +
        '\n';
    std::set_terminate([] {
        if (isWithoutMemory())
            _exit(printNoMemory());
        std::abort();
    });
}

void print(const QString &text)
{
    std::fputs(text.toUtf8().constData(), stdout);
}

void listenForInterrupt()
{
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool isInterrupted()
{
    return interrupted;
}

Output::Output()
{
    std::signal(SIGPIPE, SIG_IGN); // write() then reports a closed pipe as EPIPE
    m_buffer.reserve(2 * pieceSize);
}

bool Output::flush()
{
    std::size_t done = 0;
    while (done < m_buffer.size() && m_error == 0) {
        const ssize_t written = ::write(STDOUT_FILENO, m_buffer.data() + done, m_buffer.size() - done);
        if (written >= 0)
            done += static_cast<std::size_t>(written);
        else if (errno != EINTR)
            m_error = errno;
    }
    m_buffer.clear();
    return m_error == 0;
}

QString Output::failure() const
{
    return m_error == 0 || m_error == EPIPE ? QString() : QString::fromLocal8Bit(std::strerror(m_error));
}

TerminalLine::TerminalLine()
    : m_isShown(isatty(STDERR_FILENO)),
      m_next(std::chrono::steady_clock::now() + std::chrono::milliseconds(500))
{
}

TerminalLine::~TerminalLine()
{
    erase();
}

void TerminalLine::erase()
{
    if (m_isShown)
        std::fputs("\r\x1b[K", stderr);
}

void TerminalLine::show(const QString &text)
{
    m_next = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    std::fprintf(stderr, "\r\x1b[K%s", escaped(text).toUtf8().constData());
}

void TerminalLine::showFrame(std::int64_t frame, std::int64_t last)
{
    if (isDue())
        show(TerminalText::tr("Frame %1 of %2").arg(frame).arg(last));
}

Waiting::Waiting(const QString &what) : m_what(what)
{
    if (!isatty(STDERR_FILENO))
        return;
    listenForInterrupt();
    // Not a BackgroundJob: here the main thread does the work, and delivers no events while it does.
    m_watch = std::thread(&Waiting::watch, this);
}

Waiting::~Waiting()
{
    if (!m_watch.joinable())
        return;
    {
        const std::lock_guard lock(m_lock);
        m_ends = true;
    }
    m_isOver.notify_one();
    m_watch.join();
}

void Waiting::watch()
{
    const auto start = std::chrono::steady_clock::now();
    TerminalLine line;
    std::unique_lock lock(m_lock);
    while (!m_isOver.wait_for(lock, std::chrono::milliseconds(50), [this] { return m_ends; })) {
        if (isInterrupted()) {
            line.erase();
            printMessage(TerminalText::tr("Stopped: %1").arg(m_what));
            _exit(exitInterrupted);
        }
        const auto spent = std::chrono::steady_clock::now() - start;
        if (line.isDue())
            line.show(TerminalText::tr("%1… %2 s")
                          .arg(m_what)
                          .arg(std::chrono::duration_cast<std::chrono::seconds>(spent).count()));
    }
}

}
