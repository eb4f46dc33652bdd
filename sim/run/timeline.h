#pragma once

#include "sim/run/track.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A run that a learner controls: a cursor that can seek to any moment, and input at the cursor. If an edit
/// changes steps that were already computed, the run as it was before continues as the comparison run. Both
/// runs show the same frame, unless one of them ends before it.
class Timeline
{
public:
    static constexpr std::size_t defaultBudget = std::size_t{256} << 20;

    /// Starts at frame 0. The keyframes take at most `budget` bytes: one half for the run, one for the
    /// comparison run.
    /// @throws Error if the method cannot compute the scene
    explicit Timeline(Script script, std::size_t budget = defaultBudget);

    const Script &script() const { return m_track.script(); }
    const Track &track() const { return m_track; }
    const State &state() const { return m_track.state(); }
    Cursor cursor() const { return m_track.cursor(); }
    /// Returns the last frame that was computed.
    std::int64_t computed() const { return m_track.computed(); }
    /// Returns why the run ends, or nothing as long as no end is known.
    const std::optional<Stop> &stop() const { return m_track.stop(); }
    /// Returns the memory of the keyframes of both runs, in bytes.
    std::size_t keyframeBytes() const
    {
        return m_track.keyframeBytes() + (m_comparison ? m_comparison->keyframeBytes() : 0);
    }

    /// Moves the cursor to `target` (see Track::seek()) and the comparison run to the start of the same
    /// output step.
    void seek(Cursor target);
    /// Moves the cursor by one phase.
    void nextPhase();
    void previousPhase();
    /// Moves the cursor to the start of the next output step.
    void nextOutputStep();
    /// Moves the cursor to the start of the current output step if it is inside one, else to the one before.
    void previousOutputStep();

    /// Adds `what` as input of the output step at the cursor and removes all later input, which belonged to
    /// another future. Like the next three functions, it returns whether the previous run became the
    /// comparison run, and it changes nothing if it throws.
    /// @throws Error "input-not-finite" (event, frame)
    bool applyInput(const Input &what);
    /// Sets a parameter from the output step at the cursor on, or for the whole run if the cursor is at frame
    /// 0. Later input stays, so the two runs differ in this parameter only.
    /// @throws Error if the scene cannot be composed with the new value
    bool setParameter(const std::string &parameter, double value);
    /// Replaces the script (method, step size, effects, initial states) and stays at the same frame.
    /// @throws Error if its method cannot compute its scene
    bool replaceScript(Script script);
    /// Replaces the script as a correction of the last edit: the replaced run is forgotten, and the comparison run
    /// stays.
    /// @throws Error if its method cannot compute its scene
    void correctScript(Script script);
    /// Replaces the input and stays at the same frame. Keyframes before the first difference stay.
    /// @throws Error if the method cannot compute a scene that results from the input
    bool replaceInput(std::vector<Event> input);

    /// Returns whether playing on from the cursor would never show anything new: the cursor is at the last
    /// computed frame, and each of the two runs has ended or sleeps.
    bool isFinished() const;
    /// Returns whether the output step at the cursor has input and has not been computed with it yet.
    bool hasPendingInput() const;
    /// Returns the parameters of the output step at the cursor.
    const Values &values() const;

    /// Returns the run as it was before the last change to its past, at the cursor's frame, or null.
    const Track *comparison() const { return m_comparison ? &*m_comparison : nullptr; }
    /// Returns the first frame whose computation differs between the two runs.
    std::int64_t forkFrame() const { return m_forkFrame; }
    void dropComparison();
    /// Makes `run`, which differs from frame `forkFrame` on, the comparison run and moves it to the cursor.
    /// This takes long if `run` has no keyframe near the cursor.
    void setComparison(Track run, std::int64_t forkFrame);
    /// Swaps the run and the comparison run, with their keyframes. There must be a comparison run.
    void swapWithComparison();
    /// Returns the memory limit for the keyframes of a comparison run, in bytes.
    std::size_t comparisonBudget() const { return m_budget / 2; }

private:
    /// Prepares a change of the input from `frame` on: goes back to the start of the output step, and copies
    /// the run to the comparison run if anything after the cursor was computed. Returns whether it copied the
    /// run.
    bool prepareEdit(std::int64_t frame);
    void copyToComparison(std::int64_t forkFrame);

    Track m_track;
    std::optional<Track> m_comparison;
    std::int64_t m_forkFrame = 0; ///< the first frame whose computation differs between the two runs
    std::size_t m_budget;         ///< bytes, keyframes of both runs
};

}
