#include "sim/analysis/accuracy/errors.h"

#include "sim/analysis/accuracy/reference.h"
#include "sim/methods/methods.h"

namespace sim {

namespace {

bool isCoarser(StepSize a, StepSize b)
{
    return a.isAdaptive() ? a.tolerance > b.tolerance : a.h > b.h;
}

std::string idOf(const AccuracyRow &row)
{
    return row.setup.method->id();
}

void addInUse(const MethodSetup &inUse, std::vector<AccuracyRow> &rows)
{
    const auto isMethods = [&](const AccuracyRow &row) { return idOf(row) == inUse.method->id(); };
    auto at = std::find_if(rows.begin(), rows.end(), isMethods);
    while (at != rows.end() && isMethods(*at) && isCoarser(at->setup.step, inUse.step))
        ++at;
    if (at != rows.end() && isMethods(*at) && at->setup.step == inUse.step)
        return;
    AccuracyRow row;
    row.setup = inUse;
    rows.insert(at, std::move(row));
}

/// Measures the rows of one method, from coarse to fine.
class MethodErrors
{
public:
    MethodErrors(const Script &script, const StudyPlan &plan, const Accuracy &found, StudyMonitor &monitor)
        : m_script(script), m_plan(plan), m_found(found), m_monitor(monitor)
    {
    }

    void measure(AccuracyRow *row, AccuracyRow *end, double share)
    {
        m_share = share;
        if (row != end && !fits(row, end))
            return;
        if (m_found.reference.kind == ReferenceRun::Kind::selfRefinement && !runOwn(row->setup.method)) {
            for (; row != end; ++row)
                row->outcome = Outcome::tooLong;
            return;
        }
        for (AccuracyRow *coarser = nullptr; row != end && m_monitor.report(m_share); coarser = row++) {
            if (wouldTakeLong(*row, coarser))
                row->outcome = Outcome::tooLong;
            else
                measureOne(*row);
        }
    }

private:
    const Trajectories &places() const
    {
        return m_found.reference.kind == ReferenceRun::Kind::solution ? m_found.reference.trajectories
                                                                      : m_own;
    }

    /// Asks whether the method can compute the scene at all, and says so in its rows if not.
    bool fits(AccuracyRow *row, AccuracyRow *end) const
    {
        std::optional<Error> why = composeError(scriptFor(m_script, row->setup));
        if (!why && m_found.horizon == 0) {
            const EffectPtr &jump = m_found.reference.discontinuity;
            why = jump ? Error("no-limit", {{"effect", jump->id()}})
                       : Error("short-horizon", {{"frames", "0"}});
        }
        for (; why && row != end; ++row) {
            row->outcome = Outcome::doesNotFit;
            row->why = why;
        }
        return !why;
    }

    /// The method's own run at a fine step, as far as its numbers are finite. False: it takes too long.
    bool runOwn(const MethodPtr &method)
    {
        const double seconds = 2.0 * m_plan.secondsPerRun;
        Script own = scriptFor(m_script, {method, StepSize::ofLength(1.0)});
        own.step = finestSelfStep(own, m_found.horizon, seconds, m_monitor);
        m_finest = own.step.h;
        m_own = {placesOf(Track(own, 0).state())};
        const auto keep = [this](std::int64_t, const State &state) {
            m_own.push_back(placesOf(state));
            return true;
        };
        const RunResult run = runFrames(own, m_found.horizon, 2.0 * seconds, m_monitor, keep);
        return run.end != RunEnd::tooLong;
    }

    bool wouldTakeLong(const AccuracyRow &row, const AccuracyRow *coarser) const
    {
        if (row.setup.step.h < 4.0 * m_finest)
            return true; // too near to what it would be compared with
        if (!coarser || coarser->outcome == Outcome::unstable)
            return false; // a run that ends early tells nothing about the next
        const double more = row.setup.step.isAdaptive() ? 1.0 : coarser->setup.step.h / row.setup.step.h;
        return coarser->outcome == Outcome::tooLong || m_seconds * more > m_plan.secondsPerRun;
    }

    void measureOne(AccuracyRow &row)
    {
        const std::int64_t horizon = m_found.horizon;
        const Script script = scriptFor(m_script, row.setup);
        if (script.step.framesPerOutput > horizon) {
            row.outcome = Outcome::doesNotFit;
            row.why = Error("short-horizon", {{"frames", std::to_string(horizon)}});
            return;
        }
        row.errorAt = {0.0};
        bool isFar = false;
        const auto visit = [&](std::int64_t frame, const State &state) {
            const auto whole = static_cast<std::size_t>(frame);
            const double off = whole < places().size() ? distanceFrom(places()[whole], state) : HUGE_VAL;
            isFar = !(off <= unstableFrom);
            if (isFar)
                return false;
            row.errorAt.resize(whole,
                               row.errorAt.back()); // between two rows that are more than a frame apart
            row.errorAt.push_back(off);
            row.error = std::max(row.error, off);
            return true;
        };
        const RunResult run = runFrames(script, horizon, 2.0 * m_plan.secondsPerRun, m_monitor, visit);
        const double done = static_cast<double>(std::max<std::int64_t>(1, run.frames));
        m_seconds = run.seconds / done * static_cast<double>(horizon);
        const int each = row.setup.method->evaluationsPerStep();
        row.evaluations =
            each > 0 ? each * static_cast<double>(script.step.stepsPerOutput) / script.step.framesPerOutput
                     : run.evaluations / done;
        row.firstRun = 1e9 * run.computed / done;
        conclude(row, run.end, isFar);
    }

    static void conclude(AccuracyRow &row, RunEnd end, bool isFar)
    {
        if (isFar || end == RunEnd::notFinite)
            row.outcome = Outcome::unstable;
        else if (end == RunEnd::tooLong)
            row.outcome = Outcome::tooLong;
        else if (end == RunEnd::done)
            row.outcome = Outcome::measured;
        if (row.outcome != Outcome::measured)
            row.error = 0.0;
        if (row.outcome != Outcome::measured && row.outcome != Outcome::unstable)
            row.errorAt.clear();
    }

    const Script &m_script;
    const StudyPlan &m_plan;
    const Accuracy &m_found;
    StudyMonitor &m_monitor;
    Trajectories m_own;
    double m_finest = 0.0;  ///< frames, the step of m_own; 0 when that is not in use
    double m_seconds = 0.0; ///< that the row before took, or would have taken to the horizon
    double m_share = 0.0;
};

}

std::vector<StepSize> refinementLevels(const Method &method)
{
    std::vector<StepSize> rungs;
    if (method.stepping() == Stepping::fixed) {
        for (int steps = 1; steps <= 64; steps *= 2)
            rungs.push_back(StepSize::ofLength(1.0 / steps));
    } else {
        // Not 1e-1 * 1e-1: each is to be the number that a file has.
        for (const double tolerance : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
            rungs.push_back(StepSize::withTolerance(tolerance));
    }
    return rungs;
}

std::vector<AccuracyRow> waitingRows(const StudyPlan &plan)
{
    std::vector<AccuracyRow> rows;
    for (const MethodPtr &method : allMethods()) {
        for (const StepSize step : refinementLevels(*method)) {
            AccuracyRow row;
            row.setup = {method, step};
            rows.push_back(std::move(row));
        }
    }
    if (plan.inUse)
        addInUse(*plan.inUse, rows);
    return rows;
}

void measureErrors(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor)
{
    const std::size_t count = found.rows.size();
    for (std::size_t first = 0, end = 0; first < count && !monitor.isStopped(); first = end) {
        while (end < count && idOf(found.rows[end]) == idOf(found.rows[first]))
            ++end;
        const double share = static_cast<double>(first) / static_cast<double>(count);
        MethodErrors(script, plan, found, monitor)
            .measure(found.rows.data() + first, found.rows.data() + end, share);
    }
}

}
