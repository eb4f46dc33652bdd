#include "sim/analysis/accuracy/preview.h"

#include "sim/analysis/accuracy/errors.h"

namespace sim {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double maxSecondsPerRun = 5e-3; ///< a setup that takes longer is not previewed
constexpr double intervalFactor = 4.0;    ///< ratio of the times of two previews

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}

Preview::Preview(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor)
    : m_script(script), m_plan(plan), m_found(found), m_monitor(monitor), m_next(plan.secondsToPreview)
{
}

void Preview::update(double share)
{
    const double spent = secondsSince(m_start) - m_monitor.secondsAway();
    if (spent < m_next || m_found.horizon < 1 || m_monitor.isStopped())
        return;
    const Clock::time_point start = Clock::now();
    measure(std::max(spent, maxSecondsPerRun), share);
    m_monitor.reportNow(share);
    m_next = intervalFactor * spent;
    m_monitor.addSecondsAway(secondsSince(start));
}

void Preview::measure(double seconds, double share)
{
    m_found.rows = waitingRows(m_plan);
    m_found.previewed = m_found.horizon;
    StudyPlan quick = m_plan;
    quick.secondsPerRun = maxSecondsPerRun;
    const Clock::time_point start = Clock::now();
    const StudyProgress shouldContinue = [&](const Accuracy &, double) {
        return m_monitor.report(share) && secondsSince(start) < seconds;
    };
    StudyMonitor monitor(shouldContinue, m_found);
    measureErrors(m_script, quick, m_found, monitor);
    for (AccuracyRow &row : m_found.rows) {
        // A setup that the preview has skipped can still be measured later.
        if (row.outcome == Outcome::measured || row.outcome == Outcome::unstable)
            continue;
        row.outcome = Outcome::waiting;
        row.why.reset();
    }
}

void Preview::discard()
{
    if (m_found.previewed == 0)
        return;
    m_found.previewed = 0;
    m_found.rows = waitingRows(m_plan);
}

}
