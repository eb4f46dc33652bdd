#pragma once

#include <QString>

#include <chrono>
#include <cstdint>
#include <string>

/// What the command line says, and how it stops.
namespace app {

/// Exit codes: done; the answer is 'no'; bad use or input; stopped by Ctrl+C, as shells have it.
enum ExitCode { exitDone = 0, exitNo = 1, exitBadUse = 2, exitInterrupted = 130 };

/// Writes one line to stderr.
void say(const QString &sentence);
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

/// How far long work is: on stderr while that is a terminal (and stdout another place), and wiped away after.
class Progress
{
public:
    explicit Progress(std::int64_t frames);
    ~Progress();
    void at(std::int64_t frame)
    {
        if (m_isShown)
            show(frame);
    }

private:
    void show(std::int64_t frame);

    bool m_isShown;
    std::int64_t m_frames;
    std::chrono::steady_clock::time_point m_next;
};

}
