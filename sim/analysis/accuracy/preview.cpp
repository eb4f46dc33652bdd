#include "sim/analysis/accuracy/preview.h"

#include "sim/analysis/accuracy/errors.h"

namespace sim {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double secondsOfRun = 5e-3; ///< a rung that takes longer waits for its turn
constexpr double untilNext = 4.0;     ///< times as long as until the last one

double secondsSince(Clock::time_point begun)
{
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

}

Preview::Preview(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor)
    : m_script(script), m_plan(plan), m_found(found), m_monitor(monitor), m_next(plan.secondsToPreview)
{
}

void Preview::look(double share)
{
    const double spent = secondsSince(m_begun) - m_monitor.secondsAway();
    if (spent < m_next || m_found.horizon < 1 || m_monitor.isStopped())
        return;
    const Clock::time_point begun = Clock::now();
    measure(std::max(spent, secondsOfRun), share);
    m_monitor.reportNow(share);
    m_next = untilNext * spent;
    m_monitor.addSecondsAway(secondsSince(begun));
}

void Preview::measure(double seconds, double share)
{
    m_found.rows = waitingRows(m_plan);
    m_found.previewed = m_found.horizon;
    StudyPlan quick = m_plan;
    quick.secondsPerRun = secondsOfRun;
    const Clock::time_point begun = Clock::now();
    const StudyProgress inTime = [&](const Accuracy &, double) {
        return m_monitor.report(share) && secondsSince(begun) < seconds;
    };
    StudyMonitor monitor(inTime, m_found);
    measureErrors(m_script, quick, m_found, monitor);
    for (AccuracyRow &row : m_found.rows) {
        // What was left out now may well be measured later.
        if (row.outcome == Outcome::measured || row.outcome == Outcome::unstable)
            continue;
        row.outcome = Outcome::waiting;
        row.why.reset();
    }
}

void Preview::forget()
{
    if (m_found.previewed == 0)
        return;
    m_found.previewed = 0;
    m_found.rows = waitingRows(m_plan);
}

}
