#include "lessons/api/checks/budget.h"

#include "lessons/api/checks/exact_run.h"
#include "sim/analysis/accuracy/study_run.h"
#include "sim/analysis/accuracy/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lessons {

namespace {

constexpr double secondsOfTiming = 4e-3; ///< s, of repeated runs
/// s. A run with a longer estimate is not timed, because the window waits for the result.
constexpr double maxEstimate = 4e-3;
constexpr std::int64_t firstFrames = 10; ///< computed for the estimate
/// Steps per frame. A run with more of them exceeds every budget.
constexpr int maxStepsPerFrame = 128;

/// Estimates the computing time in ns per frame from the first frames. The estimate is rough and rather too
/// high.
double estimatedTime(const sim::Script &script)
{
    const sim::Accuracy noResult;
    const sim::StudyProgress noProgress;
    sim::StudyMonitor monitor(noProgress, noResult);
    const auto keepRunning = [](std::int64_t, const sim::State &) { return true; };
    const sim::RunResult result = sim::runFrames(script, firstFrames, maxEstimate, monitor, keepRunning);
    return 1e9 * result.seconds / static_cast<double>(std::max<std::int64_t>(1, result.frames));
}

}

double measureTime(const sim::Script &script, std::int64_t frames)
{
    const double estimate = estimatedTime(script);
    if (estimate * static_cast<double>(frames) > 1e9 * maxEstimate)
        return estimate;
    sim::StudyPlan plan;
    plan.frames = frames;
    plan.secondsOfTiming = secondsOfTiming;
    sim::Accuracy accuracy;
    accuracy.span = accuracy.horizon = frames;
    sim::AccuracyRow row;
    row.setup = {script.method, script.step};
    row.outcome = sim::Outcome::measured;
    accuracy.rows.push_back(row);
    const sim::StudyProgress noProgress;
    sim::StudyMonitor monitor(noProgress, accuracy);
    sim::measureTimes(script, plan, accuracy, monitor);
    return accuracy.rows.front().nsPerFrame;
}

bool staysWithin(const Budget &budget, const sim::Script &script, const TimeMeasurement &timing)
{
    if (script.step.stepsPerOutput > maxStepsPerFrame)
        return false;
    ExactRun exact;
    const sim::Accuracy noResult;
    const sim::StudyProgress noProgress;
    sim::StudyMonitor monitor(noProgress, noResult);
    constexpr double noTimeLimit = std::numeric_limits<double>::infinity();
    const sim::RunResult result =
        sim::runFrames(script, budget.frames, noTimeLimit, monitor,
                       [&](std::int64_t frame, const sim::State &state) { // also false for NaN
                           return exact.distance(script, state, frame) <= budget.error;
                       });
    if (result.end != sim::RunEnd::done)
        return false;
    return std::isinf(budget.nsPerFrame) || timing(script, budget.frames) <= budget.nsPerFrame;
}

}
