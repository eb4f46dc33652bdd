#pragma once

#include <QString>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

// The output of the command line, its progress on a terminal, and interruption by Ctrl+C.
namespace app {

/// The exit codes: done; the answer is no; wrong use or input; stopped by Ctrl+C (128 + SIGINT, as in shells).
enum ExitCode { exitDone = 0, exitNo = 1, exitBadUse = 2, exitInterrupted = 130 };

/// Writes one line to stderr.
void printMessage(const QString &sentence);
/// Writes to stderr that Ctrl+C has stopped the work. Returns the exit code.
int printInterrupted();
/// Writes to stderr that Ctrl+C has stopped a run of `last` frames at `frame`. Returns the exit code.
int printInterrupted(std::int64_t frame, std::int64_t last);
/// Writes to stderr that there is not enough memory. Returns the exit code.
int printNoMemory();
/// Makes the program call printNoMemory() and exit when it runs out of memory where nothing can catch the exception, for
/// example in another thread.
void handleOutOfMemory();
/// Writes text to stdout.
void print(const QString &text);

/// Makes Ctrl+C (SIGINT) and SIGTERM set isInterrupted(). A second signal ends the program at once.
void listenForInterrupt();
bool isInterrupted();

/// A buffered writer of long text to stdout.
class Output
{
public:
    Output();
    /// The buffer to append to. Append whole rows only, because the program can stop after any row.
    std::string &buffer() { return m_buffer; }
    /// Ends a row: writes the buffer if it is large. Returns false if the reader has closed the pipe, or writing failed.
    bool endRow() { return m_buffer.size() < pieceSize || flush(); }
    /// Writes the buffer. Returns as endRow().
    bool flush();
    /// Returns why flush() failed. Empty if the reader has closed the pipe, which is no error.
    QString failure() const;

private:
    static constexpr std::size_t pieceSize = std::size_t{1} << 16;
    std::string m_buffer;
    int m_error = 0;
};

/// A line on stderr about work that takes longer than half a second. It is erased afterwards. Nothing is shown if stderr
/// is not a terminal.
class TerminalLine
{
public:
    TerminalLine();
    ~TerminalLine();
    TerminalLine(const TerminalLine &) = delete;
    TerminalLine &operator=(const TerminalLine &) = delete;
    /// Returns whether it is time to show another text.
    bool isDue() const { return m_isShown && std::chrono::steady_clock::now() >= m_next; }
    void show(const QString &text);
    /// If it is time, shows that a run of `last` frames is at `frame`.
    void showFrame(std::int64_t frame, std::int64_t last);
    /// Erases the line.
    void erase();
    /// Makes isDue() false from now on.
    void hide() { m_isShown = false; }

private:
    bool m_isShown;
    std::chrono::steady_clock::time_point m_next;
};

/// A status line with the elapsed seconds, for work that cannot report its progress. Ctrl+C ends the program during this
/// work.
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
    std::thread m_watch; ///< runs only if stderr is a terminal
};

}
