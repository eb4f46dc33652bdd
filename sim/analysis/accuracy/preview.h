#pragma once

#include "sim/analysis/accuracy/study_run.h"

namespace sim {

/// Measures errors over the frames that the reference has reached so far, while it is still being computed. A
/// scene whose reference takes seconds then shows results early. The final result keeps nothing of a preview.
class Preview
{
public:
    /// All arguments must outlive the preview.
    Preview(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor);

    /// Measures rows up to the horizon of `found`, if the reference has run long enough since the last
    /// preview. This takes no longer than the reference has taken so far, and that time is not counted as the
    /// reference's.
    /// @param share progress of the reference, 0 to 1
    void update(double share);

    /// Discards the preview: all rows are waiting again.
    void discard();

private:
    void measure(double seconds, double share);

    const Script &m_script;
    const StudyPlan &m_plan;
    Accuracy &m_found;
    StudyMonitor &m_monitor;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    double m_next; ///< s, time spent on the reference at which the next preview is due
};

}
