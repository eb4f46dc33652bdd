#include "app/cli/terminal.h"

#include <QCoreApplication>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <unistd.h>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Terminal)
};

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

}

void say(const QString &sentence)
{
    std::fprintf(stderr, "%s\n", sentence.toUtf8().constData());
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
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe shows as EPIPE
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

StatusLine::StatusLine()
    : m_isShown(isatty(STDERR_FILENO)),
      m_next(std::chrono::steady_clock::now() + std::chrono::milliseconds(500))
{
}

StatusLine::~StatusLine()
{
    if (m_isShown)
        std::fputs("\r\x1b[K", stderr);
}

void StatusLine::show(const QString &text)
{
    m_next = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    std::fprintf(stderr, "\r\x1b[K%s", text.toUtf8().constData());
}

RunProgress::RunProgress(std::int64_t frames) : m_frames(frames)
{
    if (isatty(STDOUT_FILENO))
        m_line.hide();
}

void RunProgress::show(std::int64_t frame)
{
    m_line.show(Text::tr("Frame %1 of %2").arg(frame).arg(m_frames));
}

}
