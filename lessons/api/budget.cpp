#include "lessons/api/budget.h"

#include "lessons/api/exact_run.h"
#include "sim/accuracy/run.h"
#include "sim/accuracy/timing.h"

namespace lessons {

namespace {

constexpr double secondsOfTiming = 4e-3;
/// A run that takes longer than this is not compared any further. Far above any budget that is worth one.
constexpr double secondsOfComparing = 20e-3;

}

double measuredTime(const sim::Script &script, std::int64_t frames)
{
    sim::StudyPlan plan;
    plan.frames = frames;
    plan.secondsOfTiming = secondsOfTiming;
    sim::Accuracy found;
    found.span = found.horizon = frames;
    sim::AccuracyRow row;
    row.way = {script.method, script.step};
    row.outcome = sim::Outcome::measured;
    found.rows.push_back(row);
    const sim::StudyProgress nobody;
    sim::Watch watch(nobody, found);
    sim::measureTimes(script, plan, found, watch);
    return found.rows.front().nsPerFrame;
}

bool keeps(const Budget &budget, const sim::Script &script, const Timing &timing)
{
    ExactRun exact;
    const sim::Accuracy nothing;
    const sim::StudyProgress nobody;
    sim::Watch watch(nobody, nothing);
    const sim::RunResult result = sim::runFrames(
        script, budget.frames, secondsOfComparing, watch, 0.0,
        [&](std::int64_t frame, const sim::State &state) { // false, too, for what is not a number
            return exact.distance(script, state, frame) <= budget.error;
        });
    return result.end == sim::RunEnd::done && timing(script, budget.frames) <= budget.nsPerFrame;
}

}
