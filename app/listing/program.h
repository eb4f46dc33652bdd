#pragma once

#include "app/listing/values.h"
#include "app/listing/vocabulary.h"
#include "sim/scene/state.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace listing {

class Program;

/// The result of compiling: a program, or the mistakes in its text, in the order of the text.
struct Compiled
{
    std::shared_ptr<const Program> program; ///< null if there are errors
    std::vector<CompileError> errors;
};

/// The lines of a frame.
struct Trace
{
    std::vector<TracedLine> lines;
    std::vector<Variable> globals; ///< after the frame
    bool isComplete = true;        ///< whether all lines are there; see maxTracedLines
    std::optional<RunError> error; ///< the mistake that stopped the frame
};

/// A moment inside a frame.
struct Moment
{
    sim::State state;               ///< motion and memory after the lines that ran
    std::optional<TracedLine> next; ///< the line that would run next; empty at the end of the frame
    std::optional<RunError> error;  ///< the mistake that stopped the frame before; `state` is then the start
};

/// A compiled listing: the text of a program that computes one frame of a scene in its function `frame`. It does
/// not change, and several threads may use it at the same time. Its global variables are in State::memory. Empty
/// memory means that they have not been set yet: the next frame begins with their initial values.
class Program
{
public:
    /// Compiles `text`, which uses the names of `vocabulary`. A listing of 60 lines takes about 1 ms, the longest one
    /// that limits.h allows about 15 ms.
    static Compiled compile(const std::string &text, const Vocabulary &vocabulary);
    ~Program();
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    const std::string &text() const;
    const Vocabulary &vocabulary() const;
    /// Returns whether a frame depends on its number, because the listing uses `frame_number` or `random`.
    bool dependsOnTime() const;
    /// Returns whether the listing has global variables. State::memory keeps their values.
    bool remembers() const;

    /// Computes one frame. Reads and writes positions, velocities, angles, spins, the gait clock and the memory of
    /// `state`; reads its input and its frame number. After an error `state` is unchanged.
    std::optional<RunError> run(sim::State &state, const Binding &binding) const;
    /// Runs one frame from `state` and returns its lines. Consecutive parts of one source line are one line.
    Trace trace(const sim::State &state, const Binding &binding) const;
    /// Runs the first `lines` lines of a frame, counted as in trace(), or all if there are fewer.
    Moment runLines(sim::State state, const Binding &binding, int lines) const;

private:
    struct Private;
    explicit Program(std::unique_ptr<Private> data);

    std::unique_ptr<Private> m_data;
};

}
