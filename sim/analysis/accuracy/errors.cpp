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
    const auto hasMethod = [&](const AccuracyRow &row) { return idOf(row) == inUse.method->id(); };
    auto at = std::find_if(rows.begin(), rows.end(), hasMethod);
    while (at != rows.end() && hasMethod(*at) && isCoarser(at->setup.step, inUse.step))
        ++at;
    if (at != rows.end() && hasMethod(*at) && at->setup.step == inUse.step)
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
        if (m_found.reference.kind == ReferenceRun::Kind::selfRefinement &&
            !runSelfReference(row->setup.method)) {
            for (; row != end; ++row)
                row->outcome = Outcome::tooLong;
            return;
        }
        for (AccuracyRow *coarser = nullptr; row != end && m_monitor.report(m_share); coarser = row++) {
            if (wouldTakeTooLong(*row, coarser))
                row->outcome = Outcome::tooLong;
            else
                measureOne(*row);
        }
    }

private:
    const Trajectories &referencePositions() const
    {
        return m_found.reference.kind == ReferenceRun::Kind::solution ? m_found.reference.trajectories
                                                                      : m_selfReference;
    }

    /// Returns whether the method can compute the scene. If not, sets the outcome of its rows.
    bool fits(AccuracyRow *row, AccuracyRow *end) const
    {
        std::optional<Error> why = composeError(scriptFor(m_script, row->setup));
        if (!why && m_found.horizon == 0) {
            const EffectPtr &discontinuity = m_found.reference.discontinuity;
            why = discontinuity ? Error("no-limit", {{"effect", discontinuity->id()}})
                                : Error("short-horizon", {{"frames", "0"}});
        }
        for (; why && row != end; ++row) {
            row->outcome = Outcome::doesNotFit;
            row->why = why;
        }
        return !why;
    }

    /// Runs the method at a fine step, as the reference for its coarser steps. Stops at the first state that
    /// is not finite. Returns false if this takes too long.
    bool runSelfReference(const MethodPtr &method)
    {
        const double seconds = 2.0 * m_plan.secondsPerRun;
        Script fine = scriptFor(m_script, {method, StepSize::ofLength(1.0)});
        fine.step = finestSelfStep(fine, m_found.horizon, seconds, m_monitor);
        m_finestStep = fine.step.h;
        m_selfReference = {placesOf(Track(fine, 0).state())};
        const auto keep = [this](std::int64_t, const State &state) {
            m_selfReference.push_back(placesOf(state));
            return true;
        };
        const RunResult run = runFrames(fine, m_found.horizon, 2.0 * seconds, m_monitor, keep);
        return run.end != RunEnd::tooLong;
    }

    bool wouldTakeTooLong(const AccuracyRow &row, const AccuracyRow *coarser) const
    {
        if (row.setup.step.h < 4.0 * m_finestStep)
            return true; // the self-reference is not accurate enough to compare with
        if (!coarser || coarser->outcome == Outcome::unstable)
            return false; // an unstable run ends early, so its time predicts nothing
        const double costRatio = row.setup.step.isAdaptive() ? 1.0 : coarser->setup.step.h / row.setup.step.h;
        return coarser->outcome == Outcome::tooLong || m_secondsBefore * costRatio > m_plan.secondsPerRun;
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
            const auto index = static_cast<std::size_t>(frame);
            const double distance = index < referencePositions().size()
                                        ? distanceFrom(referencePositions()[index], state)
                                        : HUGE_VAL;
            isFar = !(distance <= divergenceDistance);
            if (isFar)
                return false;
            row.errorAt.resize(index, row.errorAt.back()); // frames between two output steps
            row.errorAt.push_back(distance);
            row.error = std::max(row.error, distance);
            return true;
        };
        const RunResult run = runFrames(script, horizon, 2.0 * m_plan.secondsPerRun, m_monitor, visit);
        const double framesDone = static_cast<double>(std::max<std::int64_t>(1, run.frames));
        m_secondsBefore = run.seconds / framesDone * static_cast<double>(horizon);
        const int evaluationsPerStep = row.setup.method->evaluationsPerStep();
        row.evaluations = evaluationsPerStep > 0
                              ? evaluationsPerStep * static_cast<double>(script.step.stepsPerOutput) /
                                    script.step.framesPerOutput
                              : run.evaluations / framesDone;
        row.firstRun = 1e9 * run.computed / framesDone;
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
    Trajectories m_selfReference;
    double m_finestStep = 0.0;    ///< frames, the step of m_selfReference; 0 without one
    double m_secondsBefore = 0.0; ///< of the previous row up to the horizon, extrapolated if it ended early
    double m_share = 0.0;
};

}

std::vector<StepSize> refinementLevels(const Method &method)
{
    std::vector<StepSize> levels;
    if (method.stepping() == Stepping::fixed) {
        for (int steps = 1; steps <= 64; steps *= 2)
            levels.push_back(StepSize::ofLength(1.0 / steps));
    } else {
        // Literals, because products such as 1e-1 * 1e-1 differ from the numbers that a file contains.
        for (const double tolerance : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
            levels.push_back(StepSize::withTolerance(tolerance));
    }
    return levels;
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
