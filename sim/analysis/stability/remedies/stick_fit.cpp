#include "sim/analysis/stability/remedies/stick_fit.h"

#include "sim/base/error.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr double mostWork = 1e7;          ///< of a trial: points and enforced sticks
constexpr double shortestStep = 1.0 / 64; ///< frames, of those that are tried

/// Points and enforced sticks of the steps that lead to `frame`.
double workOf(const Script &script, std::int64_t frame)
{
    const Scene scene = sceneOf(script, script.values);
    double perStep = scene.start.pointCount();
    for (const Sticks *sticks : sticksAmong(scene.effects))
        perStep += static_cast<double>(sticks->list().size()) * sticks->iterations();
    return perStep * static_cast<double>(frame) / script.step.h;
}

/// The worst stick of the last rows up to `frame`.
std::optional<StickFit> worstOf(const Script &script, std::int64_t frame,
                                const ShouldContinue &shouldContinue)
try {
    if (workOf(script, frame) > mostWork)
        return {};
    Track track(script, 0);
    StickFit worst;
    for (std::int64_t at = std::max<std::int64_t>(0, frame - fitFrames); at <= frame; ++at) {
        if (!track.seek({at, 0}, shouldContinue) || track.stop())
            return {};
        const StickFit fit = worstStick(track.interval().scene, track.state());
        if (worst.a < 0 || std::abs(fit.error) > std::abs(worst.error))
            worst = fit;
    }
    return worst;
} catch (const Error &) {
    return {}; // it does not compose
}

std::vector<Remedy> smallerSteps(const Script &script)
{
    std::vector<Remedy> all;
    for (const StepSize step : shorterSteps(script.step.h)) {
        if (step.h >= shortestStep)
            all.push_back(Remedy::of(Remedy::Kind::smallerStep, script.method, step));
    }
    return all;
}

std::vector<Remedy> morePasses(const Script &script, const IterationRange &range)
{
    std::vector<Remedy> all;
    for (double passes = 2.0 * script.values[range.parameter]; passes <= range.most; passes *= 2.0) {
        all.push_back(Remedy::of(Remedy::Kind::moreIterations, script.method, script.step));
        all.back().parameter = range.parameter;
        all.back().value = passes;
    }
    return all;
}

/// The first that leaves sticks as they should be, or else the best if it is worth it.
void addBest(const std::vector<Remedy> &candidates, const Script &script, std::int64_t frame,
             const StickFit &now, const ShouldContinue &shouldContinue, std::vector<Remedy> &into)
{
    std::optional<Remedy> best;
    for (Remedy one : candidates) {
        const std::optional<StickFit> fit = worstOf(withRemedy(script, one), frame, shouldContinue);
        if (!fit)
            continue;
        one.stickError = std::abs(fit->error);
        if (!best || *one.stickError < *best->stickError)
            best = one;
        if (*one.stickError <= fitting)
            break;
    }
    if (best && *best->stickError <= std::max(fitting, 0.5 * std::abs(now.error)))
        into.push_back(*best);
}

}

StickFit worstStick(const Scene &scene, const State &state)
{
    StickFit worst;
    for (const Sticks *sticks : sticksAmong(scene.effects)) {
        for (const Stick &one : sticks->list()) {
            if (!state.isDynamic(one.a) && !state.isDynamic(one.b))
                continue;
            const double error = stickError(one, state);
            // What is no number is worse than any.
            if (worst.a < 0 || !(std::abs(error) <= std::abs(worst.error)))
                worst = {error, one.length, one.a, one.b};
            if (std::isnan(error))
                return worst;
        }
    }
    return worst;
}

std::optional<StickAdvice> adviseOnSticks(const Script &script, std::int64_t frame,
                                          const IterationRange *passes, const ShouldContinue &shouldContinue)
{
    const std::optional<StickFit> now = worstOf(script, frame, shouldContinue);
    if (!now || now->a < 0)
        return {};
    StickAdvice advice;
    advice.now = *now;
    if (std::abs(now->error) <= fitting)
        return advice;
    if (!script.step.isAdaptive())
        addBest(smallerSteps(script), script, frame, *now, shouldContinue, advice.remedies);
    if (passes)
        addBest(morePasses(script, *passes), script, frame, *now, shouldContinue, advice.remedies);
    return shouldContinue() ? std::optional(advice) : std::nullopt;
}

}
