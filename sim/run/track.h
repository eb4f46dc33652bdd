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

/// A moment of a run: `frame` frames are done, and `phase` phases of the next row.
struct Cursor
{
    std::int64_t frame = 0;
    int phase = 0;
    friend auto operator<=>(const Cursor &, const Cursor &) = default;
};

/// What keeps a run from its next frame.
enum class StopReason {
    notFinite,    ///< a number stopped being finite
    tooManySteps, ///< a method that chooses its steps needs more of them for one frame than it may take
};

/// Where and why a run ends.
struct Stop
{
    StopReason reason = StopReason::notFinite;
    std::int64_t frame = 0; ///< the last good one
    int phases = 0;         ///< how many phases of the row after it leave good numbers
    std::string phase;      ///< title of the phase that failed first
    EffectPtr
        effect;     ///< whose phase that is; of a method's own, what pulls that point hardest; null: nothing
    int point = -1; ///< the one that failed first; -1 for what belongs to no point
    std::string body; ///< its name
    int other = -1;   ///< the point at the other end of that pull; -1: it pulls to a place, or is none
    std::string otherBody;
};

/// What one phase did to one point.
struct PhaseExplanation
{
    int phase = 0; ///< index into the pipeline's phases
    std::vector<LiveValue> live;
};

/// One run of a script, and a cursor in it. Going back is exact: the nearest kept state is restored and the rest
/// is computed again. Kept states take at most `budget` bytes: when they are full, every second one is dropped.
/// What has come to rest sleeps: rows that can only be the same again are not computed, and what they cost does not
/// depend on their number. That changes no bit of the run.
class Track
{
public:
    /// With a budget of 0 only the start is kept.
    /// @throws Error when scene and method do not fit, with any of the values that the input sets
    Track(Script script, std::size_t budget, Sleeping sleeping = Sleeping::allowed);

    const Script &script() const { return m_script; }
    const State &state() const { return m_now; }
    Cursor cursor() const { return m_at; }
    /// The last frame that was ever computed, or slept through.
    std::int64_t computed() const { return m_computed; }
    const std::optional<Stop> &stop() const { return m_stop; }
    int framesPerOutput() const { return m_script.step.framesPerOutput; }

    /// The segment that the state at the cursor belongs to.
    const ComposedInterval &interval() const { return *m_interval; }
    std::shared_ptr<const ComposedInterval> intervalPtr() const { return m_interval; }
    /// The segment whose phases run next.
    std::shared_ptr<const ComposedInterval> nextInterval() const
    {
        return intervalAt(m_at.frame + framesPerOutput());
    }
    int phasesPerOutput() const;

    /// Goes to `target`. A frame between two rows is rounded down to a row; a phase past the row's last leads to
    /// the next row; past the end of the run it goes to stop()->frame, from inside the row that fails to the last
    /// phase that leaves good numbers.
    void seek(Cursor target);
    /// The same, asking `goesOn` after each phase or step, and within a phase that takes long. Returns false when that
    /// said no: the cursor is then at a moment that was kept before, and at 0 at worst.
    bool seek(Cursor target, const ShouldContinue &shouldContinue);
    /// The state at the cursor after the input that the next row begins with; `segment` is set to its segment.
    State preview(std::shared_ptr<const ComposedInterval> &interval) const;
    /// What the phases of the step under way (or, between rows, of the last step done) did to the point named.
    std::vector<PhaseExplanation> explainPhases(const std::string &body) const;

    /// Composes every scene of `script`.
    /// @throws Error when one does not fit its method, or when a number of the input is not finite
    static void check(const Script &script);
    /// Input for replaceInput(), with its scenes.
    struct NewInput
    {
        std::vector<Event> events;
        std::int64_t frame = 0; ///< the first in which it may differ
        ComposedIntervals intervals;
    };
    /// Composes every scene of the script with `events` from `frame` on, before anything changes, so that no step
    /// meets a scene that its method cannot compute.
    /// @throws Error when one does not, or when a number of the input is not finite
    NewInput prepareInput(std::vector<Event> events, std::int64_t frame) const;
    /// Replaces the input, which prepared() has returned, and forgets what was computed from its frame on. The cursor
    /// must stand between two rows, before that frame.
    void replaceInput(NewInput input);
    /// The sleep that the cursor is in; null while the run is awake.
    const Sleep *sleep() const { return sleepAt(m_at.frame); }
    /// Whether the cursor stands between two rows where nothing is to be seen any more, however long the run goes on: it
    /// sleeps without moving (see Sleep::isStill()) and no input is to come, or it has come to its end.
    bool isFinished() const;
    /// Limits the kept states to `budget` bytes from now on.
    void setBudget(std::size_t budget);
    /// The state at the end of row `frame`, which was computed before.
    State stateAt(std::int64_t frame) const { return *outputState(frame, {}); }
    /// `end`, the state at the end of row `frame`, after the input that the next row begins with.
    State stateAfterInput(State end, std::int64_t frame) const;
    /// The segment that it belongs to.
    std::shared_ptr<const ComposedInterval> intervalAt(std::int64_t frame) const
    {
        return m_intervals.at(m_script, frame);
    }
    /// The last frame up to `frame` whose state is known: from there the way to `frame` is computed again.
    std::int64_t cachedFrameBefore(std::int64_t frame) const;
    std::size_t keyframeBytes() const { return m_keyframes.bytes(); }
    std::size_t keyframeCount() const { return m_keyframes.count(); }
    /// The memory of what sleeps: the states of one round each.
    std::size_t sleepBytes() const { return m_keyframes.sleepBytes(); }

private:
    void restore(std::int64_t frame);
    /// The nearest known state at the end of a row that is not after `frame`.
    State cachedState(std::int64_t frame) const;
    /// Takes `state`, at the end of a row, into the row that ends at `rowEnd`: applies its input.
    void begin(State &state, std::int64_t outputEnd) const;
    /// Whether the run goes on.
    enum class Progress { continues, stopped, cancelled };
    /// Runs the next step if `target` is not inside it, else the next phase.
    Progress advance(Cursor target, const ShouldContinue &shouldContinue);
    /// One step on a state that is at the beginning of one, without the blocks that are `asleep` (see runStep()).
    /// Returns false when `goesOn` said no on the way.
    bool runOneStep(const Pipeline &pipeline, State &state, const std::vector<char> &asleep,
                    const ShouldContinue &shouldContinue) const;
    /// Takes the state at the cursor into the next row.
    void beginOutputStep(Cursor target);
    Progress endOutputStep(const ShouldContinue &shouldContinue);
    /// Takes `state`, at the end of the row before, through the row that ends at `rowEnd`. Returns whether it is done.
    bool runOutputStep(State &state, std::int64_t outputEnd, const ShouldContinue &shouldContinue) const;
    /// Goes back to the last good row, and finds out what failed after it.
    Progress recordStop(const ShouldContinue &shouldContinue);
    /// The state at the end of a row that was computed before, computed again from the nearest known one. Empty when
    /// `goesOn` said no on the way.
    std::optional<State> outputState(std::int64_t frame, const ShouldContinue &shouldContinue) const;

    const Sleep *sleepAt(std::int64_t frame) const;
    /// The last frame that `sleep` reaches: the next input ends it.
    std::int64_t lastFrameOf(const Sleep &sleep) const;
    /// At the end of a row: whether the run, or a block of it, has come to rest.
    void detectSleep();
    void detectSleepingBlocks();
    /// Sleeps on, up to `frame` if nothing wakes it before. Returns whether it got anywhere.
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
    CycleDetector m_watch;
    BlockCycleDetector m_blocks;
    bool m_skips = false;      ///< whether the row under way leaves out the blocks that sleep
    mutable ThreadPool m_pool; ///< for steps that are large enough to share
};

}
