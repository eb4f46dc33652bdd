#include "sim/analysis/stability/remedies/stick_fit.h"

#include "sim/base/error.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr double maxWork = 1e7;      ///< per trial: points and stick iterations, summed over the steps
constexpr double minStep = 1.0 / 64; ///< frames, the shortest step to try

/// Returns the points and stick iterations of all steps up to `frame`.
double workOf(const Script &script, std::int64_t frame)
{
    const Scene scene = sceneOf(script, script.values);
    double perStep = scene.start.pointCount();
    for (const Sticks *sticks : sticksAmong(scene.effects))
        perStep += static_cast<double>(sticks->list().size()) * sticks->iterations();
    return perStep * static_cast<double>(frame) / script.step.h;
}

/// Returns the worst stick of the last fitFrames frames up to `frame`. Empty if the run does not reach it or
/// would take too long.
std::optional<StickFit> worstUpTo(const Script &script, std::int64_t frame,
                                  const ShouldContinue &shouldContinue)
try {
    if (workOf(script, frame) > maxWork)
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
    return {}; // the script does not compose
}

std::vector<Remedy> smallerSteps(const Script &script)
{
    std::vector<Remedy> all;
    for (const StepSize step : shorterSteps(script.step.h)) {
        if (step.h >= minStep)
            all.push_back(Remedy::of(Remedy::Kind::smallerStep, script.method, step));
    }
    return all;
}

std::vector<Remedy> moreIterations(const Script &script, const IterationRange &range)
{
    std::vector<Remedy> all;
    for (double iterations = 2.0 * script.values[range.parameter]; iterations <= range.most;
         iterations *= 2.0) {
        all.push_back(Remedy::of(Remedy::Kind::moreIterations, script.method, script.step));
        all.back().parameter = range.parameter;
        all.back().value = iterations;
    }
    return all;
}

/// Adds the first candidate that makes all sticks fit. If none does, adds the best one, if it halves the
/// error.
void addBest(const std::vector<Remedy> &candidates, const Script &script, std::int64_t frame,
             const StickFit &now, const ShouldContinue &shouldContinue, std::vector<Remedy> &remedies)
{
    std::optional<Remedy> best;
    for (Remedy remedy : candidates) {
        const std::optional<StickFit> fit = worstUpTo(withRemedy(script, remedy), frame, shouldContinue);
        if (!fit)
            continue;
        remedy.stickError = std::abs(fit->error);
        if (!best || *remedy.stickError < *best->stickError)
            best = remedy;
        if (*remedy.stickError <= fitting)
            break;
    }
    if (best && *best->stickError <= std::max(fitting, 0.5 * std::abs(now.error)))
        remedies.push_back(*best);
}

}

StickFit worstStick(const Scene &scene, const State &state)
{
    StickFit worst;
    for (const Sticks *sticks : sticksAmong(scene.effects)) {
        for (const Stick &stick : sticks->list()) {
            if (!state.isDynamic(stick.a) && !state.isDynamic(stick.b))
                continue;
            const double error = stickError(stick, state);
            // An error that is not a number is worse than any other.
            if (worst.a < 0 || !(std::abs(error) <= std::abs(worst.error)))
                worst = {error, stick.length, stick.a, stick.b};
            if (std::isnan(error))
                return worst;
        }
    }
    return worst;
}

std::optional<StickAdvice> stickAdvice(const Script &script, std::int64_t frame,
                                       const IterationRange *iterations, const ShouldContinue &shouldContinue)
{
    const std::optional<StickFit> now = worstUpTo(script, frame, shouldContinue);
    if (!now || now->a < 0)
        return {};
    StickAdvice advice;
    advice.now = *now;
    if (std::abs(now->error) <= fitting)
        return advice;
    if (!script.step.isAdaptive())
        addBest(smallerSteps(script), script, frame, *now, shouldContinue, advice.remedies);
    if (iterations)
        addBest(moreIterations(script, *iterations), script, frame, *now, shouldContinue, advice.remedies);
    return shouldContinue() ? std::optional(advice) : std::nullopt;
}

}
