#pragma once

#include "sim/analysis/accuracy/study.h"

#include <chrono>

namespace sim {

/// Tells who asked for a study how far it is, a few times a second, and learns whether to go on.
class StudyMonitor
{
public:
    /// Both must outlive this.
    StudyMonitor(const StudyProgress &progress, const Accuracy &soFar) : m_progress(progress), m_soFar(soFar)
    {
    }

    /// From here on shares are parts of the stretch `from` to `to` of the whole study.
    void beginPart(double from, double to)
    {
        m_from = from;
        m_to = to;
        m_share = 0.0;
    }
    /// Tells, if the last time is a while ago, that `share` (0 to 1) of this part is done. Returns whether to go on.
    bool report(double share)
    {
        m_share = share;
        return report();
    }
    /// The same, with the share as it was told last.
    bool report() { return Clock::now() < m_next ? !m_stopped : reportNow(m_share); }
    /// Tells it at once.
    bool reportNow(double share)
    {
        if (!m_stopped && m_progress)
            m_stopped = !m_progress(m_soFar, m_from + (m_to - m_from) * share);
        m_next = Clock::now() + std::chrono::milliseconds(50);
        return !m_stopped;
    }
    bool isStopped() const { return m_stopped; }
    /// Seconds that went to something else than what is under way: runs do not count them as theirs.
    double secondsAway() const { return m_away; }
    void addSecondsAway(double seconds) { m_away += seconds; }

private:
    using Clock = std::chrono::steady_clock;

    const StudyProgress &m_progress;
    const Accuracy &m_soFar;
    double m_from = 0.0;
    double m_to = 1.0;
    double m_away = 0.0;
    double m_share = 0.0;
    bool m_stopped = false;
    Clock::time_point m_next = Clock::now();
};

}
