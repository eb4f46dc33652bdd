#include "sim/analysis/accuracy/reference.h"

#include "sim/methods/methods.h"
#include "sim/methods/ode_system.h"

namespace sim {

namespace {

constexpr int maxSelfSteps = 256; ///< per frame, 4 times as many as at the finest refinement level
constexpr int minSelfSteps = 8;   ///< per frame

/// Returns the first effect without a continuous limit, in any scene that the script composes up to `frames`,
/// or null.
EffectPtr firstDiscontinuity(const Script &script, std::int64_t frames)
{
    const auto discontinuityWith = [&](const Values &values) {
        return OdeSystem::firstDiscontinuity(sceneOf(script, values), OdeSystem::Contacts::allowed);
    };
    Values values = script.values;
    EffectPtr discontinuity = discontinuityWith(values);
    for (const Event &event : script.input) {
        const Set *set = std::get_if<Set>(&event.what);
        if (!set || discontinuity || event.frame > frames)
            continue;
        values.set(set->parameter, set->value);
        discontinuity = discontinuityWith(values);
    }
    return discontinuity;
}

/// Returns the setups that can serve as a reference, the best first. These are two different embedded pairs
/// of high order with tight tolerances, then the methods of fixed step by order, at a fine step.
std::vector<MethodSetup> candidates()
{
    std::vector<MethodSetup> setups;
    for (const auto &[id, tolerance] : {std::pair{"dop853", 1e-12}, {"dormand_prince", 1e-12}}) {
        if (const MethodPtr method = findMethod(id))
            setups.push_back({method, StepSize::withTolerance(tolerance)});
    }
    std::vector<MethodSetup> fixed;
    for (const MethodPtr &method : allMethods()) {
        if (method->stepping() == Stepping::fixed)
            fixed.push_back({method, StepSize::ofLength(1.0 / maxSelfSteps)});
    }
    std::stable_sort(fixed.begin(), fixed.end(), [](const MethodSetup &a, const MethodSetup &b) {
        return a.method->order() > b.method->order();
    });
    setups.insert(setups.end(), fixed.begin(), fixed.end());
    return setups;
}

/// Returns the first two of candidates() that can compute `script`.
std::vector<MethodSetup> fittingPair(const Script &script)
{
    std::vector<MethodSetup> pair;
    for (const MethodSetup &setup : candidates()) {
        if (pair.size() < 2 && !composeError(scriptFor(script, setup)))
            pair.push_back(setup);
    }
    return pair;
}

/// Runs a reference and its check side by side. Stores the positions while both agree within `agreement` px.
void runPair(const Script &script, const std::vector<MethodSetup> &pair, double agreement, double seconds,
             Accuracy &found, StudyMonitor &monitor, Preview &preview)
{
    ReferenceRun &reference = found.reference;
    reference.step = pair[0].step;
    reference.checkStep = pair[1].step;
    Track check(scriptFor(script, pair[1]), 0);
    reference.trajectories = {placesOf(check.state())};
    const auto end = [&reference](RunEnd why) {
        if (why == RunEnd::notFinite)
            reference.end = ReferenceRun::End::notFinite;
        if (why == RunEnd::tooLong)
            reference.end = ReferenceRun::End::tooLong;
    };
    TimeLimit timeLimit(seconds, monitor);
    const ShouldContinue shouldContinue = timeLimit.callback();
    const auto visit = [&](std::int64_t frame, const State &state) {
        const bool isReached = check.seek({frame, 0}, shouldContinue);
        if (!isReached || check.stop()) {
            end(isReached ? endOf(*check.stop()) : timeLimit.end());
            return false;
        }
        std::vector<Vec2> positions = placesOf(state);
        const double distance = distanceFrom(positions, check.state());
        if (!(distance <= agreement)) {
            reference.end = ReferenceRun::End::diverged;
            return false;
        }
        reference.disagreement = std::max(reference.disagreement, distance);
        reference.trajectories.push_back(std::move(positions));
        found.horizon = frame;
        const double share = static_cast<double>(frame) / static_cast<double>(found.span);
        preview.update(share);
        return monitor.report(share);
    };
    const RunResult run = runFrames(scriptFor(script, pair[0]), found.span, seconds, monitor, visit);
    end(run.end);
}

}

StepSize finestSelfStep(const Script &script, std::int64_t frames, double seconds, StudyMonitor &monitor)
{
    const Script coarse = scriptFor(script, {script.method, StepSize::ofLength(1.0)});
    const auto visit = [](std::int64_t, const State &) { return true; };
    const RunResult run = runFrames(coarse, frames, seconds / minSelfSteps, monitor, visit);
    const double perFrame = run.seconds / static_cast<double>(std::max<std::int64_t>(1, run.frames));
    int steps = maxSelfSteps;
    while (steps > minSelfSteps && perFrame * static_cast<double>(frames) * steps > seconds)
        steps /= 2;
    return StepSize::ofLength(1.0 / steps);
}

void findReference(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor,
                   Preview &preview)
{
    ReferenceRun &reference = found.reference;
    reference.discontinuity = firstDiscontinuity(script, plan.frames);
    if (!reference.discontinuity) {
        const std::vector<MethodSetup> pair = fittingPair(script);
        reference.end = ReferenceRun::End::diverged;
        if (pair.size() < 2)
            return; // no second method computes this scene
        reference.end = ReferenceRun::End::span;
        reference.method = pair[0].method->id();
        reference.check = pair[1].method->id();
        runPair(script, pair, referenceAgreement, 10.0 * plan.secondsPerRun, found, monitor, preview);
        return;
    }
    reference.kind = ReferenceRun::Kind::selfRefinement;
    reference.method = reference.check = "own_refinement";
    if (script.method->stepping() == Stepping::adaptive)
        return; // unreachable: adaptive methods compute no scene with discontinuities
    const StepSize finest = finestSelfStep(script, plan.frames, 2.0 * plan.secondsPerRun, monitor);
    const std::vector<MethodSetup> pair = {{script.method, finest},
                                           {script.method, StepSize::ofLength(2.0 * finest.h)}};
    runPair(script, pair, selfAgreement, 10.0 * plan.secondsPerRun, found, monitor, preview);
    reference.trajectories.clear(); // each method is compared with its own run
}

}
