#pragma once

#include "sim/forward.h"
#include "sim/run/keyframe_store.h"
#include "sim/run/script/composed_intervals.h"
#include "sim/run/sleeping/block_cycle_detector.h"
#include "sim/scene/explanation.h"
#include "sim/simd/thread_pool.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A moment of a run: `frame` frames are computed, and `phase` phases of the next output step.
struct Cursor
{
    std::int64_t frame = 0;
    int phase = 0;
    friend auto operator<=>(const Cursor &, const Cursor &) = default;
};

/// The reason why a run ends.
enum class StopReason {
    notFinite,    ///< a number stopped being finite
    tooManySteps, ///< an adaptive method exceeded its step budget for one frame
    stepFailed,   ///< the method could not compute the step; see State::stepFailed
};

/// Where and why a run ends.
struct Stop
{
    StopReason reason = StopReason::notFinite;
    std::int64_t frame = 0; ///< the last frame without failure
    int phases = 0;         ///< the number of phases of the next output step that succeed
    std::string phase;      ///< title of the phase that failed first
    /// The effect that failed. If the phase belongs to the method: the strongest force on `point`, or null.
    EffectPtr effect;
    int point = -1;        ///< the point that failed first; -1: the failed number belongs to no point
    std::string body;      ///< name of `point`
    int other = -1;        ///< the point at the other end of the force; -1: none
    std::string otherBody; ///< name of `other`
};

/// The effect of one phase on one point.
struct PhaseExplanation
{
    int phase = 0;               ///< index into the pipeline's phases
    std::vector<LiveValue> live; ///< values of variables in the shown code
};

/// A run of a script with a cursor. Seeking back is exact: the track restores the nearest keyframe and
/// computes the rest again. The keyframes take at most `budget` bytes. If they exceed it, every second one is
/// dropped. A run whose states repeat exactly sleeps: it is not computed again, and skipping any number of
/// output steps costs the same. The result is the same in every bit.
class Track
{
public:
    /// Starts at frame 0. With a budget of 0, only the initial state is kept.
    /// @throws Error if the method cannot compute the scene with all parameter values that the input sets
    Track(Script script, std::size_t budget, Sleeping sleeping = Sleeping::allowed);

    const Script &script() const { return m_script; }
    const State &state() const { return m_now; }
    Cursor cursor() const { return m_at; }
    /// Returns the last frame that was computed or skipped in sleep.
    std::int64_t computed() const { return m_computed; }
    /// Returns why the run ends, or nothing as long as no end is known.
    const std::optional<Stop> &stop() const { return m_stop; }
    int framesPerOutput() const { return m_script.step.framesPerOutput; }

    /// Returns the composed interval of the state at the cursor.
    const ComposedInterval &interval() const { return *m_interval; }
    std::shared_ptr<const ComposedInterval> intervalPtr() const { return m_interval; }
    /// Returns the composed interval of the next output step.
    std::shared_ptr<const ComposedInterval> nextInterval() const
    {
        return intervalAt(m_at.frame + framesPerOutput());
    }
    /// Returns the number of phases in the next output step.
    int phasesPerOutput() const;

    /// Moves the cursor to `target`. Rounds the frame down to the end of an output step. A phase after the
    /// last of an output step means the start of the next one. A target after the end of the run becomes
    /// stop()->frame. Within the output step that fails, a later phase becomes the last one that succeeds.
    void seek(Cursor target);
    /// Does the same, and calls `shouldContinue` after each phase or step and within long phases. If it
    /// returns false, this returns false too, with the cursor at the last known state before the moment it
    /// had reached.
    bool seek(Cursor target, const ShouldContinue &shouldContinue);
    /// Returns the state at the cursor. Between two output steps, the input of the next one is already
    /// applied. Sets `interval` to the composed interval of the result.
    State preview(std::shared_ptr<const ComposedInterval> &interval) const;
    /// Explains the finished phases of the current step for the point named `body`. Between two output steps,
    /// explains the last step.
    std::vector<PhaseExplanation> explainPhases(const std::string &body) const;

    /// Composes every scene of `script`.
    /// @throws Error if the method cannot compute one of them, or if a number of the input is not finite
    static void check(const Script &script);
    /// New input for replaceInput(), with its composed scenes.
    struct NewInput
    {
        std::vector<Event> events;
        std::int64_t frame = 0; ///< the first frame at which it may differ from the old input
        ComposedIntervals intervals;
    };
    /// Composes every scene that `events` produce from `frame` on. The run does not change yet, so an error
    /// leaves it intact.
    /// @throws Error if the method cannot compute one of them, or if a number of the input is not finite
    NewInput prepareInput(std::vector<Event> events, std::int64_t frame) const;
    /// Replaces the input by a result of prepareInput() and forgets everything computed from its frame on.
    /// The cursor must be between two output steps, before that frame.
    void replaceInput(NewInput input);
    /// Returns the sleep at the cursor, or null if the run is awake there.
    const Sleep *sleep() const { return sleepAt(m_at.frame); }
    /// Returns whether nothing visible happens after the cursor: the run ends here, or it sleeps without
    /// moving (see Sleep::isStill()) and has no more input. Asleep, the cursor must also be between two
    /// output steps.
    bool isFinished() const;
    /// Limits the keyframes to `budget` bytes from now on.
    void setBudget(std::size_t budget);
    /// Returns the state at `frame`, the end of an output step that was computed before.
    State stateAt(std::int64_t frame) const { return *outputState(frame, {}); }
    /// Returns `end`, the state at `frame`, with the input of the next output step applied.
    State stateAfterInput(State end, std::int64_t frame) const;
    /// Returns the composed interval of the output step that ends at `frame`.
    std::shared_ptr<const ComposedInterval> intervalAt(std::int64_t frame) const
    {
        return m_intervals.at(m_script, frame);
    }
    /// Returns the last frame at or before `frame` whose state is known without computing a step.
    std::int64_t cachedFrameBefore(std::int64_t frame) const;
    /// Returns the memory of the keyframes, in bytes.
    std::size_t keyframeBytes() const { return m_keyframes.bytes(); }
    std::size_t keyframeCount() const { return m_keyframes.count(); }
    /// Returns the memory of the states of all sleeps, in bytes.
    std::size_t sleepBytes() const { return m_keyframes.sleepBytes(); }

private:
    /// Moves the cursor to the last known state at or before `frame`.
    void restore(std::int64_t frame);
    /// Returns the last known state at or before `frame`.
    State cachedState(std::int64_t frame) const;
    /// Applies the input of the output step that ends at `outputEnd` to `state`, the end of the one before.
    void applyInput(State &state, std::int64_t outputEnd) const;
    /// The result of an attempt to advance the run.
    enum class Progress { continues, stopped, cancelled };
    /// Runs the next step if it ends at or before `target`, else the next phase.
    Progress advance(Cursor target, const ShouldContinue &shouldContinue);
    /// Runs one step from its start, without the cache blocks that are `asleep` (see runStep()). Returns
    /// false if it was cancelled.
    bool runOneStep(const Pipeline &pipeline, State &state, const std::vector<char> &asleep,
                    const ShouldContinue &shouldContinue) const;
    /// Applies the input of the next output step at the cursor.
    void beginOutputStep(Cursor target);
    /// Checks the result, moves the cursor to the end of the output step, and keeps the state.
    Progress endOutputStep(const ShouldContinue &shouldContinue);
    /// Computes the output step that ends at `outputEnd`, from `state`, the end of the one before. Returns
    /// false if it was cancelled.
    bool runOutputStep(State &state, std::int64_t outputEnd, const ShouldContinue &shouldContinue) const;
    /// Goes back to the last good output step and sets `m_stop` to the first failure after it.
    Progress recordStop(const ShouldContinue &shouldContinue);
    /// Returns the state at `frame`, computed again from the last known one. Returns nothing if it was
    /// cancelled.
    std::optional<State> outputState(std::int64_t frame, const ShouldContinue &shouldContinue) const;

    /// Returns the sleep at `frame`, or null if the run is awake there.
    const Sleep *sleepAt(std::int64_t frame) const;
    /// Returns the last frame of `sleep`, which the next input ends.
    std::int64_t lastFrameOf(const Sleep &sleep) const;
    /// Detects at the end of an output step whether the run, or a cache block of it, repeats.
    void detectSleep();
    void detectSleepingBlocks();
    /// If the run sleeps, moves the cursor to `frame` or to the end of the sleep, whichever is first. Returns
    /// whether the cursor moved.
    bool skipSleep(std::int64_t frame);

    Script m_script;
    ComposedIntervals m_intervals;
    Sleeping m_sleeping;
    std::shared_ptr<const ComposedInterval> m_interval;
    State m_now;
    Cursor m_at;
    std::int64_t m_computed = 0;
    std::optional<Stop> m_stop;
    KeyframeStore m_keyframes;
    CycleDetector m_cycleDetector;
    BlockCycleDetector m_blockDetector;
    bool m_skipsSleepingBlocks = false; ///< whether the current output step skips sleeping cache blocks
    mutable ThreadPool m_pool;          ///< for steps with many points
};

}
