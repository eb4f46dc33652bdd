#pragma once

#include "sim/forward.h"
#include "sim/run/keyframe_store.h"
#include "sim/run/script/composed_intervals.h"
#include "sim/run/sleeping/block_cycle_detector.h"
#include "sim/scene/live.h"
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
struct Moment
{
    int phase = 0; ///< index into the pipeline's phases
    std::vector<Live> live;
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
    const State &now() const { return m_now; }
    Cursor at() const { return m_at; }
    /// The last frame that was ever computed, or slept through.
    std::int64_t computed() const { return m_computed; }
    const std::optional<Stop> &stop() const { return m_stop; }
    int rowFrames() const { return m_script.step.rowFrames; }

    /// The segment that the state at the cursor belongs to.
    const Segment &shown() const { return *m_segment; }
    std::shared_ptr<const Segment> shownPtr() const { return m_segment; }
    /// The segment whose phases run next.
    std::shared_ptr<const Segment> next() const { return segmentAt(m_at.frame + rowFrames()); }
    int phasesPerRow() const;

    /// Goes to `target`. A frame between two rows is rounded down to a row; a phase past the row's last leads to
    /// the next row; past the end of the run it goes to stop()->frame, from inside the row that fails to the last
    /// phase that leaves good numbers.
    void seek(Cursor target);
    /// The same, asking `goesOn` after each phase or step, and within a phase that takes long. Returns false when that
    /// said no: the cursor is then at a moment that was kept before, and at 0 at worst.
    bool seek(Cursor target, const GoesOn &goesOn);
    /// The state at the cursor after the input that the next row begins with; `segment` is set to its segment.
    State preview(std::shared_ptr<const Segment> &segment) const;
    /// What the phases of the step under way (or, between rows, of the last step done) did to the point named.
    std::vector<Moment> moments(const std::string &body) const;

    /// Composes every scene of `script`.
    /// @throws Error when one does not fit its method, or when a number of the input is not finite
    static void check(const Script &script);
    /// Input for replaceInput(), with its scenes.
    struct NewInput
    {
        std::vector<Event> events;
        std::int64_t frame = 0; ///< the first in which it may differ
        Segments segments;
    };
    /// Composes every scene of the script with `events` from `frame` on, before anything changes, so that no step
    /// meets a scene that its method cannot compute.
    /// @throws Error when one does not, or when a number of the input is not finite
    NewInput prepared(std::vector<Event> events, std::int64_t frame) const;
    /// Replaces the input, which prepared() has returned, and forgets what was computed from its frame on. The cursor
    /// must stand between two rows, before that frame.
    void replaceInput(NewInput input);
    /// The sleep that the cursor is in; null while the run is awake.
    const Sleep *sleep() const { return sleepAt(m_at.frame); }
    /// Whether the cursor stands between two rows where nothing is to be seen any more, however long the run goes on: it
    /// sleeps without moving (see Sleep::isStill()) and no input is to come, or it has come to its end.
    bool isOver() const;
    /// Limits the kept states to `budget` bytes from now on.
    void setBudget(std::size_t budget);
    /// The state at the end of row `frame`, which was computed before.
    State stateAt(std::int64_t frame) const { return *rowState(frame, {}); }
    /// `end`, the state at the end of row `frame`, after the input that the next row begins with.
    State begunAfter(State end, std::int64_t frame) const;
    /// The segment that it belongs to.
    std::shared_ptr<const Segment> segmentAt(std::int64_t frame) const
    {
        return m_segments.at(m_script, frame);
    }
    /// The last frame up to `frame` whose state is known: from there the way to `frame` is computed again.
    std::int64_t knownBefore(std::int64_t frame) const;
    std::size_t keptBytes() const { return m_history.bytes(); }
    std::size_t keptStates() const { return m_history.states(); }
    /// The memory of what sleeps: the states of one round each.
    std::size_t sleepBytes() const { return m_history.sleepBytes(); }

private:
    void restore(std::int64_t frame);
    /// The nearest known state at the end of a row that is not after `frame`.
    State known(std::int64_t frame) const;
    /// Takes `state`, at the end of a row, into the row that ends at `rowEnd`: applies its input.
    void begin(State &state, std::int64_t rowEnd) const;
    /// Whether the run goes on.
    enum class Next { goesOn, ends, isLeftOff };
    /// Runs the next step if `target` is not inside it, else the next phase.
    Next runOn(Cursor target, const GoesOn &goesOn);
    /// One step on a state that is at the beginning of one, without the blocks that are `asleep` (see runStep()).
    /// Returns false when `goesOn` said no on the way.
    bool runWhole(const Pipeline &pipeline, State &state, const std::vector<char> &asleep,
                  const GoesOn &goesOn) const;
    /// Takes the state at the cursor into the next row.
    void beginRow(Cursor target);
    Next endRow(const GoesOn &goesOn);
    /// Takes `state`, at the end of the row before, through the row that ends at `rowEnd`. Returns whether it is done.
    bool runRow(State &state, std::int64_t rowEnd, const GoesOn &goesOn) const;
    /// Goes back to the last good row, and finds out what failed after it.
    Next stopHere(const GoesOn &goesOn);
    /// The state at the end of a row that was computed before, computed again from the nearest known one. Empty when
    /// `goesOn` said no on the way.
    std::optional<State> rowState(std::int64_t frame, const GoesOn &goesOn) const;

    const Sleep *sleepAt(std::int64_t frame) const;
    /// The last frame that `sleep` reaches: the next input ends it.
    std::int64_t lastOf(const Sleep &sleep) const;
    /// At the end of a row: whether the run, or a block of it, has come to rest.
    void fallAsleep();
    void blocksFallAsleep();
    /// Sleeps on, up to `frame` if nothing wakes it before. Returns whether it got anywhere.
    bool sleepOn(std::int64_t frame);

    Script m_script;
    Segments m_segments;
    Sleeping m_sleeping;
    std::shared_ptr<const Segment> m_segment;
    State m_now;
    Cursor m_at;
    std::int64_t m_computed = 0;
    std::optional<Stop> m_stop;
    History m_history;
    SleepWatch m_watch;
    BlockSleep m_blocks;
    bool m_skips = false; ///< whether the row under way leaves out the blocks that sleep
    mutable Crew m_crew;  ///< for steps that are large enough to share
};

}
