#pragma once

#include "app/listing/script_runner.h"
#include "sim/scene/state.h"

#include <optional>
#include <string>
#include <vector>

namespace listing {

/// What a frame does besides computing the new state.
struct Recording
{
    std::vector<TracedLine> *lines = nullptr; ///< receives each line, up to maxTracedLines; null: none
    /// Number of lines to run: the frame is left before the next one. Negative: all.
    int stopAfter = -1;
    bool findsNonFinite = false; ///< whether the first line that makes a number infinite or NaN is an error
};

/// The result of Interpreter::run().
struct RunResult
{
    std::optional<RunError> error;
    bool isStopped = false;         ///< whether it was left because of Recording::stopAfter
    bool isComplete = true;         ///< whether all lines were recorded
    std::optional<TracedLine> next; ///< if it was left: the line before which it stopped
    std::vector<Variable> globals;  ///< after the frame, if its lines were recorded
};

/// A compiled listing with the memory for one frame. Program makes one for each thread.
class Interpreter : public ScriptRunner
{
public:
    /// Compiles the text of `scan`. Both arguments must outlive this object.
    Interpreter(const SourceScan &scan, const Vocabulary &vocabulary);

    /// Computes a frame of `state`. If it is left by an error, `state` does not change, except that
    /// Recording::stopAfter leaves it as it is inside the frame.
    RunResult run(sim::State &state, const Binding &binding, const Recording &recording);

private:
    /// A global variable of the listing.
    struct Global
    {
        const char *name;
        int type;
        unsigned index;
        std::size_t bytes;
    };

    void findFrame();
    void findGlobals();
    void store(sim::State &state) const;
    RunResult execute(const sim::State &state, const Binding &binding, const Recording &recording);
    void runFrame();
    /// Sets the globals to their initial values.
    void initialise();
    /// Makes sure that the globals have addresses, which they only have once they had a value.
    void allocateGlobals(const sim::State &state, const Binding &binding);
    /// Returns where a global is; null if it never had a value.
    void *addressOf(const Global &global) const;
    void onNewLine(int line, int column, int depth) override;
    void record(int line, int column, int depth);
    /// Adds the bodies that have changed since the last call to the last recorded line.
    void recordChanges();
    /// Makes the first number that is not finite an error of the line before, unless there is an error. Returns whether
    /// all are finite.
    bool checkFinite();
    /// Returns the name of the first position, velocity or global that is not finite, or an empty string.
    std::string firstNonFinite() const;
    std::vector<Variable> variables() const override;

    asIScriptFunction *m_frame = nullptr;
    std::vector<Global> m_globals;
    std::size_t m_memoryBytes = 0;

    // The frame that is running.
    Recording m_recording;
    RunResult m_result;
    int m_lines = 0;                    ///< lines so far, of which a line with several parts is one
    TracedLine m_before;                ///< the line that runs now, for findsNonFinite
    std::vector<BodyMotion> m_recorded; ///< all bodies at the last call of recordChanges()
    std::vector<BodyMotion> m_motions;  ///< all bodies now
};

}
