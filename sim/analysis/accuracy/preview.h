#pragma once

#include "sim/analysis/accuracy/study_run.h"

namespace sim {

/// What can be said before the reference has reached the end of the span: errors over the frames that it has reached.
/// Whoever watches need not wait for a scene whose exact motion takes seconds. Nothing of it stays in the result.
class Preview
{
public:
    /// All must outlive this.
    Preview(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor);

    /// Measures rows up to the horizon of `found`, if the reference has taken long enough since the last time.
    /// Takes no longer than the reference has, and counts as time away from it.
    void look(double share);
    /// All rows wait again.
    void forget();

private:
    void measure(double seconds, double share);

    const Script &m_script;
    const StudyPlan &m_plan;
    Accuracy &m_found;
    StudyMonitor &m_monitor;
    std::chrono::steady_clock::time_point m_begun = std::chrono::steady_clock::now();
    double m_next; ///< s, of the reference's time
};

}
