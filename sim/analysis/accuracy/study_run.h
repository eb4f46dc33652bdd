#pragma once

#include "sim/analysis/accuracy/study_monitor.h"
#include "sim/base/cpu_clock.h"
#include "sim/run/track.h"

#include <algorithm>

namespace sim {

/// Where each point is, at one whole frame after the other.
using Trajectories = std::vector<std::vector<Vec2>>;

/// How a run over whole frames ended.
enum class RunEnd {
    done,
    notFinite,
    stoppedByVisitor, ///< who looked on had seen enough
    tooLong,
    cancelled, ///< nobody wants the study any more
};

struct RunResult
{
    RunEnd end = RunEnd::done;
    std::int64_t frames = 0; ///< computed, all finite
    double seconds = 0.0;
    double computed = 0.0;    ///< seconds without what other programs took
    double evaluations = 0.0; ///< how often all points had their turn, as State counts that
};

/// How a run ends that stops by itself.
RunEnd endOf(const Stop &stop);

/// `script` computed in another way.
Script scriptFor(const Script &script, const MethodSetup &setup);

/// Why `script` cannot be computed as it says, or nothing.
std::optional<Error> composeError(const Script &script);

std::vector<Vec2> placesOf(const State &state);

/// The largest distance of any point of `state` from where `places` has it, in px; NaN if one is not finite.
double distanceFrom(const std::vector<Vec2> &places, const State &state);

/// Whether a run may go on: until nobody wants it any more, or it takes too long.
class TimeLimit
{
public:
    /// `watch` must outlive this.
    TimeLimit(double seconds, StudyMonitor &monitor)
        : m_seconds(seconds), m_monitor(monitor), m_awayBefore(monitor.secondsAway())
    {
    }

    bool shouldContinue()
    {
        if (!m_monitor.report())
            m_end = RunEnd::cancelled;
        else if (secondsSpent() > m_seconds)
            m_end = RunEnd::tooLong;
        return m_end == RunEnd::done;
    }
    /// To be asked by what is computed; this must outlive it.
    ShouldContinue callback()
    {
        return [this] { return shouldContinue(); };
    }
    /// Seconds since this was made, without those that went to something else.
    double secondsSpent() const
    {
        return std::chrono::duration<double>(Clock::now() - m_start).count() -
               (m_monitor.secondsAway() - m_awayBefore);
    }
    /// Why it said no, or RunEnd::done.
    RunEnd end() const { return m_end; }

private:
    using Clock = std::chrono::steady_clock;

    double m_seconds;
    StudyMonitor &m_monitor;
    double m_awayBefore;
    Clock::time_point m_start = Clock::now();
    RunEnd m_end = RunEnd::done;
};

/// Runs `script` for `frames` frames, but not longer than `seconds`. After each row that is done it calls
/// `visit(frame, state)`, and leaves off when that returns false.
/// @throws Error when scene and method do not fit
template <class Visit>
RunResult runFrames(const Script &script, std::int64_t frames, double seconds, StudyMonitor &monitor,
                    Visit &&visit)
{
    Track track(script, 0, Sleeping::never); // what a frame costs is measured on the way
    TimeLimit patience(seconds, monitor);
    const ShouldContinue shouldContinue = patience.callback();
    const double computedBefore = threadCpuSeconds();
    RunResult result;
    const double before = track.state().forceEvaluations();
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames && result.end == RunEnd::done;
         frame += track.framesPerOutput()) {
        const bool isThere = track.seek({frame, 0}, shouldContinue);
        result.seconds = patience.secondsSpent();
        if (!isThere) {
            result.end = patience.end();
        } else if (track.stop()) {
            result.end = endOf(*track.stop());
        } else {
            result.frames = frame;
            result.evaluations = track.state().forceEvaluations() - before;
            if (!visit(frame, track.state()))
                result.end = RunEnd::stoppedByVisitor;
        }
    }
    result.computed = threadCpuSeconds() - computedBefore;
    return result;
}

}
