#pragma once

#include "sim/analysis/accuracy/study.h"

#include <chrono>

namespace sim {

/// Reports the progress of a study a few times a second, and remembers whether it was stopped.
class StudyMonitor
{
public:
    /// Both must outlive the monitor.
    StudyMonitor(const StudyProgress &progress, const Accuracy &soFar) : m_progress(progress), m_soFar(soFar)
    {
    }

    /// Begins the part of the study from `from` to `to` (of 1). Shares are shares of this part from now on.
    void beginPart(double from, double to)
    {
        m_from = from;
        m_to = to;
        m_share = 0.0;
    }
    /// Reports that `share` (0 to 1) of this part is done, unless the last report was less than 50 ms ago.
    /// Returns whether to continue.
    bool report(double share)
    {
        m_share = share;
        return report();
    }
    /// Reports again with the last share.
    bool report() { return Clock::now() < m_next ? !m_stopped : reportNow(m_share); }
    /// Reports at once, even shortly after another report.
    bool reportNow(double share)
    {
        if (!m_stopped && m_progress)
            m_stopped = !m_progress(m_soFar, m_from + (m_to - m_from) * share);
        m_next = Clock::now() + std::chrono::milliseconds(50);
        return !m_stopped;
    }
    bool isStopped() const { return m_stopped; }
    /// Returns the seconds spent on previews, which time limits do not count.
    double secondsAway() const { return m_secondsAway; }
    void addSecondsAway(double seconds) { m_secondsAway += seconds; }

private:
    using Clock = std::chrono::steady_clock;

    const StudyProgress &m_progress;
    const Accuracy &m_soFar;
    double m_from = 0.0;
    double m_to = 1.0;
    double m_secondsAway = 0.0;
    double m_share = 0.0;
    bool m_stopped = false;
    Clock::time_point m_next = Clock::now();
};

}
