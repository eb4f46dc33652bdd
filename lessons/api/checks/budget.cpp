#include "lessons/api/checks/budget.h"

#include "lessons/api/checks/exact_run.h"
#include "sim/analysis/accuracy/study_run.h"
#include "sim/analysis/accuracy/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lessons {

namespace {

constexpr double secondsOfTiming = 4e-3;
/// A run that seems to take longer than this is not timed more closely: the window waits for it.
constexpr double longestRun = 4e-3; // s
constexpr std::int64_t firstFrames = 10;
/// Steps a frame: with more a run is not looked at.
constexpr int mostSteps = 128;

/// What a frame takes in the first few, in ns: a rough figure, on the high side.
double roughTime(const sim::Script &script)
{
    const sim::Accuracy nothing;
    const sim::StudyProgress nobody;
    sim::StudyMonitor monitor(nobody, nothing);
    const auto goOn = [](std::int64_t, const sim::State &) { return true; };
    const sim::RunResult result = sim::runFrames(script, firstFrames, longestRun, monitor, goOn);
    return 1e9 * result.seconds / static_cast<double>(std::max<std::int64_t>(1, result.frames));
}

}

double measureTime(const sim::Script &script, std::int64_t frames)
{
    const double rough = roughTime(script);
    if (rough * static_cast<double>(frames) > 1e9 * longestRun)
        return rough;
    sim::StudyPlan plan;
    plan.frames = frames;
    plan.secondsOfTiming = secondsOfTiming;
    sim::Accuracy found;
    found.span = found.horizon = frames;
    sim::AccuracyRow row;
    row.setup = {script.method, script.step};
    row.outcome = sim::Outcome::measured;
    found.rows.push_back(row);
    const sim::StudyProgress nobody;
    sim::StudyMonitor monitor(nobody, found);
    sim::measureTimes(script, plan, found, monitor);
    return found.rows.front().nsPerFrame;
}

bool staysWithin(const Budget &budget, const sim::Script &script, const TimeMeasurement &timing)
{
    if (script.step.stepsPerOutput > mostSteps)
        return false;
    ExactRun exact;
    const sim::Accuracy nothing;
    const sim::StudyProgress nobody;
    sim::StudyMonitor monitor(nobody, nothing);
    constexpr double anyTime = std::numeric_limits<double>::infinity();
    const sim::RunResult result =
        sim::runFrames(script, budget.frames, anyTime, monitor,
                       [&](std::int64_t frame, const sim::State &state) { // false, too, for what is no number
                           return exact.distance(script, state, frame) <= budget.error;
                       });
    if (result.end != sim::RunEnd::done)
        return false;
    return std::isinf(budget.nsPerFrame) || timing(script, budget.frames) <= budget.nsPerFrame;
}

}
