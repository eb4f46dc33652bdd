#pragma once

#include "sim/script.h"

#include <array>
#include <compare>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>

namespace sim {

/// A moment of a run: `frame` frames are done, and `phase` phases of the next row.
struct Cursor
{
    std::int64_t frame = 0;
    int phase = 0;
    friend auto operator<=>(const Cursor &, const Cursor &) = default;
};

/// A stretch of a run in which no parameter changes: the scene, composed.
struct Segment
{
    Values values;
    Scene scene;
    Pipeline pipeline;
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
class Track
{
public:
    /// With a budget of 0 only the start is kept.
    /// @throws Error when scene and method do not fit, with any of the values that the input sets
    Track(Script script, std::size_t budget);

    const Script &script() const { return m_script; }
    const State &now() const { return m_now; }
    Cursor at() const { return m_at; }
    /// The last frame that was ever computed.
    std::int64_t computed() const { return m_computed; }
    const std::optional<Stop> &stop() const { return m_stop; }
    int rowFrames() const { return m_script.step.rowFrames; }

    /// The segment that the state at the cursor belongs to.
    const Segment &shown() const { return *m_segment; }
    std::shared_ptr<const Segment> shownPtr() const { return m_segment; }
    /// The segment whose phases run next.
    std::shared_ptr<const Segment> next() const { return segmentFor(m_at.frame + rowFrames()); }
    int phasesPerRow() const { return next()->pipeline.phasesPerRow(); }

    /// Goes to `target`. A frame between two rows is rounded down to a row; a phase past the row's last leads to
    /// the next row; past the end of the run it goes to stop()->frame, from inside the row that fails to the last
    /// phase that leaves good numbers.
    void seek(Cursor target);
    /// The same, asking `goesOn` after each phase, and within one that takes long. Returns false when that said no:
    /// the cursor is then at a moment that was kept before, and at 0 at worst.
    bool seek(Cursor target, const GoesOn &goesOn);
    /// The state at the cursor after the input that the next row begins with; `segment` is set to its segment.
    State preview(std::shared_ptr<const Segment> &segment) const;
    /// What the phases of the step under way (or, between rows, of the last step done) did to the point named.
    std::vector<Moment> moments(const std::string &body) const;

    /// Composes each scene that `script` comes to from `frame` on, so that no step meets one that does not fit.
    /// @throws Error when one does not, or when a number of the input is not finite
    static void check(const Script &script, std::int64_t frame);
    /// Replaces the input, which may differ from `frame` on only, and forgets what was computed from there. The
    /// cursor must stand between two rows, before `frame`.
    void replaceInput(std::vector<Event> input, std::int64_t frame);
    /// Limits the kept states to `budget` bytes from now on.
    void setBudget(std::size_t budget);
    /// The state at the end of row `frame`, which was computed before.
    State stateAt(std::int64_t frame) const { return *rowState(frame, {}); }
    /// `end`, the state at the end of row `frame`, after the input that the next row begins with.
    State begunAfter(State end, std::int64_t frame) const;
    /// The segment that it belongs to.
    std::shared_ptr<const Segment> segmentAt(std::int64_t frame) const { return segmentFor(frame); }
    /// The last frame up to `frame` whose state is kept: from there a way to `frame` is computed again.
    std::int64_t keptBefore(std::int64_t frame) const { return std::prev(m_kept.upper_bound(frame))->first; }
    std::size_t keptBytes() const { return m_keptBytes; }
    std::size_t keptStates() const { return m_kept.size(); }

private:
    struct Change
    {
        std::int64_t frame;
        Values values;
    };
    static std::vector<Change> changesOf(const Script &script);

    std::shared_ptr<const Segment> segmentFor(std::int64_t rowEnd) const;
    void restore(std::int64_t frame);
    /// Takes `state`, at the end of a row, into the row that ends at `rowEnd`: applies its input.
    void begin(State &state, std::int64_t rowEnd) const;
    void apply(State &state, const Scene &scene, const Event &event) const;
    void applyHand(State &state, const Scene &scene, const Event &event) const;
    /// Whether the run goes on.
    enum class Next { goesOn, ends, isLeftOff };
    Next runPhase(const GoesOn &goesOn);
    Next endRow(const GoesOn &goesOn);
    /// Goes back to the last good row, and finds out what failed after it.
    Next stopHere(const GoesOn &goesOn);
    /// The state at the end of a row that was computed before, computed again from the nearest kept one. Empty when
    /// `goesOn` said no on the way.
    std::optional<State> rowState(std::int64_t frame, const GoesOn &goesOn) const;
    void keep();
    void thin();

    Script m_script;
    std::vector<Change>
        m_changes; ///< values in force from a row's end on, by frame; the first is the start's
    struct Composed
    {
        std::int64_t from = -1; ///< frame of its change
        std::shared_ptr<const Segment> segment;
    };
    /// The segments last asked for, the latest first: those before and after a change are asked for in turn.
    mutable std::array<Composed, 2> m_composed;
    std::shared_ptr<const Segment> m_segment;
    State m_now;
    Cursor m_at;
    std::int64_t m_computed = 0;
    std::optional<Stop> m_stop;
    std::map<std::int64_t, std::shared_ptr<const State>> m_kept; ///< by frame; 0 is never dropped
    std::size_t m_keptBytes = 0;
    std::size_t m_budget;
    std::int64_t m_spacing = 1; ///< rows between two kept states
};

}
