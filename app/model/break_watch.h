#pragma once

#include "app/model/breakpoints.h"
#include "app/model/condition.h"
#include "lessons/api/step.h"
#include "sim/run/timeline.h"

namespace app {

/// That a run has stopped, and for which breakpoint.
struct BreakHit
{
    int id = 0; ///< the breakpoint's
    sim::Cursor at;
    QString sentence; ///< "Stopped at frame 41 before gravity: foot0.y > 380."
};

/// What conditions of `step` may speak of where `timeline` stands.
ConditionNames conditionNames(const lessons::Step &step, const sim::Timeline &timeline);

/// The phases of one step of `pipeline` that have the line `place` in their source.
std::vector<int> phasesAt(const CodePlace &place, const sim::Pipeline &pipeline);

/// Takes runs forward and stops them at breakpoints: at one with a line before each phase of that line (where its
/// condition holds); at one without before the first phase where its condition holds and did not the phase before. The
/// place where it begins never counts, so that going on goes on.
class BreakWatch
{
public:
    /// From now on these breakpoints of `step`, which must outlive it, are looked out for.
    void watch(const std::vector<Breakpoint> &breakpoints, const lessons::Step &step);
    /// Whether there is anything to look out for.
    bool isWatching() const { return !m_watched.empty(); }

    /// Takes `run` on to `target`, to the end of the run, or to where it is to stop; says which if it is that.
    std::optional<BreakHit> run(sim::Timeline &run, sim::Cursor target);
    /// Whether a run that is over (see Timeline::isOver()) may still come to a stop if time goes on.
    bool mayStillStop(const sim::Timeline &run) const;

private:
    struct Watched
    {
        Breakpoint breakpoint;
        std::optional<Condition> condition;
        std::vector<int> phases; ///< of a step; empty without a line
        bool isInForce = false;  ///< whether its line runs here, and its condition makes sense here
        bool held = false;       ///< whether the condition held a phase ago; without a line only
    };

    /// Reads conditions and places anew where scene or pipeline are others than before.
    void fit(const sim::Timeline &run);
    void look(const sim::Timeline &run);
    bool holds(const Watched &one, const sim::Timeline &run) const;
    sim::Cursor nextPlace(const sim::Timeline &run, sim::Cursor target) const;
    std::optional<BreakHit> hitAt(const sim::Timeline &run);

    const lessons::Step *m_step = nullptr;
    std::vector<Watched> m_watched;
    std::shared_ptr<const sim::ComposedInterval> m_shown, m_next; ///< what m_watched fits
    sim::Cursor m_last;                                           ///< where run() left off
    int m_rowsOver = 0; ///< rows in a row that were looked at since the run is over
};

}
