#pragma once

#include "sim/run/track.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A run that a learner steers: a cursor that goes anywhere, input at the cursor, and the run as it was before
/// the last change to its past, which goes on beside it as a ghost.
class Timeline
{
public:
    static constexpr std::size_t defaultBudget = std::size_t{256} << 20;

    /// `budget`: memory for kept states in bytes, half of it for the ghost.
    /// @throws Error when scene and method do not fit
    explicit Timeline(Script script, std::size_t budget = defaultBudget);

    const Script &script() const { return m_track.script(); }
    const Track &track() const { return m_track; }
    const State &state() const { return m_track.state(); }
    Cursor cursor() const { return m_track.cursor(); }
    std::int64_t computed() const { return m_track.computed(); }
    const std::optional<Stop> &stop() const { return m_track.stop(); }
    std::size_t keyframeBytes() const
    {
        return m_track.keyframeBytes() + (m_ghost ? m_ghost->keyframeBytes() : 0);
    }

    void seek(Cursor target);
    /// One phase on or back.
    void nextPhase();
    void previousPhase();
    /// One row on; to the start of this row if inside one, else one row back.
    void nextOutputStep();
    void previousOutputStep();

    /// What a learner does now: it becomes input of the row at the cursor. Later input is forgotten: it belonged to
    /// another future. Returns whether the run as it was became the ghost; so do the next two.
    /// @throws Error "input-not-finite" (event, frame) for what is nowhere; nothing has changed then
    bool applyInput(const Input &what);
    /// A parameter changes now: at the start of the run for the whole run, later from the row at the cursor on.
    /// Later input stays, so that the two runs differ by this alone.
    /// @throws Error when the scene does not compose with the new value; nothing has changed then
    bool setParameter(const std::string &parameter, double value);
    /// Another script (method, step, effects, starts), at the same frame.
    /// @throws Error when its scene and method do not fit; nothing has changed then
    bool replaceScript(Script script);
    /// Other input at the same frame: what was computed before the two differ stays.
    /// @throws Error when a scene that the input comes to does not fit; nothing has changed then
    bool replaceInput(std::vector<Event> input);

    /// Whether playing on from the cursor shows nothing new for ever: all that was computed is past, and the run and
    /// its ghost are over or asleep.
    bool isFinished() const;
    /// Whether input waits for the row at the cursor that has not been computed since.
    bool hasPendingInput() const;
    /// The parameters in force for the row at the cursor.
    const Values &values() const;

    /// The run as it was before the last change to its past, at the cursor's frame; null if there is none.
    const Track *comparison() const { return m_ghost ? &*m_ghost : nullptr; }
    /// The frame from which the ghost differs.
    std::int64_t forkFrame() const { return m_fork; }
    void dropComparison();
    /// `run` goes on beside this one from now on, differing from frame `fork` on. It should be near the cursor: it is
    /// taken there at once.
    void setComparison(Track run, std::int64_t fork);
    /// Run and ghost, which must be there, change places, with all that is kept of them.
    void swapWithComparison();
    /// The memory for a ghost's kept states, in bytes.
    std::size_t comparisonBudget() const { return m_budget / 2; }

private:
    /// Before input from `frame` on changes: goes back to the start of the row, and makes a ghost of the run if
    /// that has a future. Returns whether it did.
    bool openOutputStep(std::int64_t frame);
    void becomeComparison(std::int64_t fork);

    Track m_track;
    std::optional<Track> m_ghost;
    std::int64_t m_fork = 0;
    std::size_t m_budget;
};

}
