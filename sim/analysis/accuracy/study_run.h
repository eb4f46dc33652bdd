#pragma once

#include "sim/analysis/accuracy/study_monitor.h"
#include "sim/base/cpu_clock.h"
#include "sim/run/track.h"

#include <algorithm>

namespace sim {

/// px, positions of all points at each whole frame.
using Trajectories = std::vector<std::vector<Vec2>>;

/// How a run over whole frames ended.
enum class RunEnd {
    done,
    notFinite,
    stoppedByVisitor, ///< the visitor returned false
    tooLong,
    cancelled, ///< the study was stopped
};

/// The result of runFrames().
struct RunResult
{
    RunEnd end = RunEnd::done;
    std::int64_t frames = 0;  ///< frames computed, all with finite numbers
    double seconds = 0.0;     ///< wall time, without previews
    double computed = 0.0;    ///< s, CPU time of the thread
    double evaluations = 0.0; ///< evaluations of all forces, see State::forceEvaluations()
};

/// Returns how a run ended that stopped at `stop`.
RunEnd endOf(const Stop &stop);

/// Returns `script` with the method and step of `setup`.
Script scriptFor(const Script &script, const MethodSetup &setup);

/// Returns the error of composing `script`, if there is one.
std::optional<Error> composeError(const Script &script);

/// Returns the positions of all points, px.
std::vector<Vec2> placesOf(const State &state);

/// Returns the largest distance of any point of `state` from its position in `places`, in px, or NaN if one
/// is not finite.
double distanceFrom(const std::vector<Vec2> &places, const State &state);

/// Limits the time of a run, and ends it when the study is stopped.
class TimeLimit
{
public:
    /// `monitor` must outlive this object.
    TimeLimit(double seconds, StudyMonitor &monitor)
        : m_seconds(seconds), m_monitor(monitor), m_awayAtStart(monitor.secondsAway())
    {
    }

    /// Reports progress and returns whether the run may continue.
    bool shouldContinue()
    {
        if (!m_monitor.report())
            m_end = RunEnd::cancelled;
        else if (secondsSpent() > m_seconds)
            m_end = RunEnd::tooLong;
        return m_end == RunEnd::done;
    }

    /// Returns shouldContinue() as a function. This object must outlive the function.
    ShouldContinue callback()
    {
        return [this] { return shouldContinue(); };
    }

    /// Returns the seconds since construction, without those spent on previews.
    double secondsSpent() const
    {
        return std::chrono::duration<double>(Clock::now() - m_start).count() -
               (m_monitor.secondsAway() - m_awayAtStart);
    }

    /// Returns why the run must end, or RunEnd::done while it may continue.
    RunEnd end() const { return m_end; }

private:
    using Clock = std::chrono::steady_clock;

    double m_seconds;
    StudyMonitor &m_monitor;
    double m_awayAtStart;
    Clock::time_point m_start = Clock::now();
    RunEnd m_end = RunEnd::done;
};

/// Runs `script` for `frames` frames, but no longer than `seconds`. Calls `visit(frame, state)` after each
/// output step, and stops when it returns false.
/// @throws Error when scene and method do not fit
template <class Visit>
RunResult runFrames(const Script &script, std::int64_t frames, double seconds, StudyMonitor &monitor,
                    Visit &&visit)
{
    Track track(script, 0, Sleeping::never); // sleeping would falsify the time per frame
    TimeLimit timeLimit(seconds, monitor);
    const ShouldContinue shouldContinue = timeLimit.callback();
    const double cpuBefore = threadCpuSeconds();
    RunResult result;
    const double evaluationsBefore = track.state().forceEvaluations();
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames && result.end == RunEnd::done;
         frame += track.framesPerOutput()) {
        const bool isReached = track.seek({frame, 0}, shouldContinue);
        result.seconds = timeLimit.secondsSpent();
        if (!isReached) {
            result.end = timeLimit.end();
        } else if (track.stop()) {
            result.end = endOf(*track.stop());
        } else {
            result.frames = frame;
            result.evaluations = track.state().forceEvaluations() - evaluationsBefore;
            if (!visit(frame, track.state()))
                result.end = RunEnd::stoppedByVisitor;
        }
    }
    result.computed = threadCpuSeconds() - cpuBefore;
    return result;
}

}
