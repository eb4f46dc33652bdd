#pragma once

#include "app/model/breakpoints/breakpoints.h"
#include "app/model/breakpoints/condition.h"
#include "app/model/listing/listing_frame.h"
#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <functional>
#include <memory>
#include <utility>

namespace app {

/// The breakpoint at which a run has stopped.
struct BreakHit
{
    int id = 0; ///< id of the breakpoint
    sim::Cursor at;
    int lines = 0;    ///< lines of the listing that have run in the next frame; 0 at a phase
    QString sentence; ///< "Stopped at frame 41 before gravity: foot0.y > 380."
};

/// The lines of the frame after the cursor, if a listing computes the run.
struct LinesAhead
{
    std::shared_ptr<const ListingFrame> frame; ///< null: no listing
    int index = 0;                             ///< lines that have run
};

/// Returns the names that conditions of `step` may use at the cursor of `timeline`.
ConditionNames conditionNames(const lessons::Step &step, const sim::Timeline &timeline);

/// Returns the phases in one step of `pipeline` whose source contains the line `place`.
std::vector<int> phasesAt(const CodePlace &place, const sim::Pipeline &pipeline);

/// Advances runs and stops them at breakpoints. A breakpoint with a line stops before each phase of that line, if its
/// condition holds, and one in the listing each time before the line runs. A breakpoint without a line stops before the
/// first phase at which its condition becomes true. With variables of a listing, it stops before the first line of the
/// listing instead. The starting point never counts, so a stopped run can go on.
class BreakpointMonitor
{
public:
    /// Sets the breakpoints of `step` to watch from now on. `step` must outlive this monitor.
    void watch(const std::vector<Breakpoint> &breakpoints, const lessons::Step &step);
    /// Sets the function that returns the lines after the cursor of the run. Without it, the run never stops before a line
    /// of a listing.
    void setLines(std::function<LinesAhead()> lines) { m_lines = std::move(lines); }
    /// Returns whether there are breakpoints to watch.
    bool isWatching() const { return !m_watched.empty(); }

    /// Advances `run` to `target`, to the end of the run, or to the next breakpoint. Returns the breakpoint if the run
    /// stopped at one.
    std::optional<BreakHit> run(sim::Timeline &run, sim::Cursor target);
    /// Returns the breakpoint that stops the run inside its next frame, after the line that runs next and before `lines`
    /// lines of the frame have run.
    std::optional<BreakHit> hitBeforeLine(const sim::Timeline &run, int lines);
    /// Returns whether a finished run (see Timeline::isOver()) can still reach a breakpoint when it continues.
    bool mayStillStop(const sim::Timeline &run) const;

private:
    struct Watched
    {
        Breakpoint breakpoint;
        std::optional<Condition> condition;
        std::vector<int> phases; ///< of a step; empty without a line
        bool isInForce = false;  ///< whether the line runs here, and the condition is valid here
        bool isOfLines = false;  ///< whether it stops before lines of the listing, not before phases
        bool held = false;       ///< whether the condition held one phase ago; only without a line
    };

    /// Parses the conditions and finds the phases again if the scene or the pipeline has changed.
    void fit(const sim::Timeline &run);
    void checkBreakpoints(const sim::Timeline &run);
    bool holds(const Watched &one, const sim::Timeline &run) const;
    sim::Cursor nextPlace(const sim::Timeline &run, sim::Cursor target) const;
    /// Returns whether a breakpoint of lines stops the run before the line at `index` of `frame`, where `state` is. Ignores
    /// whether it held before.
    bool holdsBeforeLine(const Watched &one, const sim::State &state, const ListingFrame &frame,
                         int index) const;
    std::optional<BreakHit> hitAt(const sim::Timeline &run);
    /// Checks the lines of the next frame: those after the one that runs next, all of them, or the first one alone.
    enum class Lines { behindCursor, all, first };
    std::optional<BreakHit> hitInLines(const sim::Timeline &run, Lines lines, int mostLines);

    const lessons::Step *m_step = nullptr;
    std::vector<Watched> m_watched;
    std::shared_ptr<const sim::ComposedInterval> m_shown,
        m_next; ///< the intervals that m_watched was prepared for
    std::function<LinesAhead()> m_lines;
    sim::Cursor m_last = {-1, 0}; ///< where run() stopped last
    int m_outputStepsOver = 0;    ///< consecutive output steps checked since the run was over
};

}
