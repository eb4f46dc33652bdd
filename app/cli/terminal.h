#pragma once

#include <QString>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

/// What the command line says, and how it stops.
namespace app {

/// Exit codes: done; the answer is 'no'; bad use or input; stopped by Ctrl+C, as shells have it.
enum ExitCode { exitDone = 0, exitNo = 1, exitBadUse = 2, exitInterrupted = 130 };

/// Writes one line to stderr.
void say(const QString &sentence);
/// Says that there is not enough memory. Returns the exit code.
int sayNoMemory();
/// From now on a program that has no memory left where nothing can catch that (in another thread, say) says so, and ends
/// with exitBadUse.
void endWithASentenceWithoutMemory();
/// Writes text to stdout.
void print(const QString &text);

/// From now on Ctrl+C asks for a clean stop; a second one stops at once.
void listenForInterrupt();
bool isInterrupted();

/// Much text to stdout, in large pieces.
class Output
{
public:
    Output();
    /// Where to append. Whole rows only: what is here when the program stops is written.
    std::string &buffer() { return m_buffer; }
    /// Writes the buffer if it is large. False: nobody reads any more, or the writing failed.
    bool rowDone() { return m_buffer.size() < pieceSize || flush(); }
    bool flush();
    /// Why flush() failed; empty when the reader has closed the pipe, which is no error.
    QString failure() const;

private:
    static constexpr std::size_t pieceSize = std::size_t{1} << 16;
    std::string m_buffer;
    int m_error = 0;
};

/// One line about long work: on stderr while that is a terminal, shown from half a second on, and wiped away after.
class StatusLine
{
public:
    StatusLine();
    ~StatusLine();
    StatusLine(const StatusLine &) = delete;
    StatusLine &operator=(const StatusLine &) = delete;
    /// Whether it is time to show another text.
    bool isDue() const { return m_isShown && std::chrono::steady_clock::now() >= m_next; }
    void show(const QString &text);
    /// Takes away what it shows.
    void wipe();
    /// Shows nothing from now on.
    void hide() { m_isShown = false; }

private:
    bool m_isShown;
    std::chrono::steady_clock::time_point m_next;
};

/// Says what takes long, on stderr while that is a terminal, where nothing tells how far it is: from half a second on, with
/// the seconds that it took so far. Ctrl+C ends the program.
class Waiting
{
public:
    explicit Waiting(const QString &what);
    ~Waiting();
    Waiting(const Waiting &) = delete;
    Waiting &operator=(const Waiting &) = delete;

private:
    void watch();

    QString m_what;
    std::mutex m_lock;
    std::condition_variable m_isOver;
    bool m_ends = false;
    std::thread m_watch; ///< only where there is a terminal
};

/// How far a run is, on a status line while stdout is another place than the terminal.
class RunProgress
{
public:
    explicit RunProgress(std::int64_t frames);
    void at(std::int64_t frame)
    {
        if (m_line.isDue())
            show(frame);
    }

private:
    void show(std::int64_t frame);

    StatusLine m_line;
    std::int64_t m_frames;
};

}
