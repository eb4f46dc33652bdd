#include "sim/analysis/stability/stability.h"

#include "sim/analysis/stability/modes/step_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr double factorToDistinctMode = 1.02; ///< the first growing mode is distinct from others here

Bound boundOf(const Method &method)
{
    switch (method.stepLimit()) {
    case StepLimit::none:
        return Bound::none;
    case StepLimit::tolerance:
        return Bound::tolerance;
    case StepLimit::stiffness:
        break;
    }
    return Bound::stiffness;
}

bool hasVelocityForce(const Scene &scene, const State &state)
{
    return std::any_of(scene.effects.begin(), scene.effects.end(), [&](const EffectPtr &effect) {
        const auto *force = as<Force>(effect);
        return force && force->dependsOnVelocity() && !force->isIdle() &&
               force->count(state, {0, state.pointCount()}) > 0;
    });
}

/// Returns the factor per frame for a logarithm per step. Growth within rounding counts as none.
double factorPerFrame(double growth, double rounding, double h)
{
    const double factor = std::exp(growth / h);
    return growth <= rounding ? std::min(1.0, factor) : factor;
}

/// Returns how a mode changes from step to step, by the direction of its factor in the complex plane.
GrowthKind growthKindOf(std::complex<double> factor)
{
    if (std::abs(factor.imag()) > 1e-6 * std::abs(factor))
        return GrowthKind::oscillating;
    return factor.real() < 0.0 ? GrowthKind::alternating : GrowthKind::monotonic;
}

/// Returns a step at which the dominant mode grows: the step in use, or one just past the limit.
double stepShowingMode(const Stability &found)
{
    if (found.growth > 1.0 || !std::isfinite(found.limit) || found.limit <= 0.0)
        return found.h;
    return factorToDistinctMode * found.limit;
}

}

double Stability::share() const
{
    if (std::isinf(limit))
        return 0.0;
    return limit > 0.0 ? h / limit : std::numeric_limits<double>::infinity();
}

Stability stabilityOf(const Scene &scene, const State &state, const Method &method, double h)
{
    Stability found;
    found.h = h;
    found.bound = boundOf(method);
    if (found.bound == Bound::stiffness && state.pointCount() > maxAnalysedPoints)
        found.bound = Bound::tooLarge;
    else if (found.bound == Bound::stiffness && hasVelocityForce(scene, state))
        found.bound = Bound::velocity;
    if (found.bound != Bound::stiffness)
        return found;
    const LinearisedScene linearised = linearise(scene, state, method);
    found.ignored = linearised.ignored;
    if (!linearised.finite) {
        found.bound = Bound::unknown;
        return found;
    }
    const std::unique_ptr<StepAnalysis> analysis = stepAnalysisOf(linearised, method);
    found.stiffness = analysis->stiffest();
    if (found.stiffness == 0.0) {
        found.bound = Bound::noSprings;
        return found;
    }
    found.growth = factorPerFrame(analysis->growth(h), analysis->rounding(), h);
    found.limit = analysis->limit();
    const Mode mode = analysis->dominantMode(stepShowingMode(found));
    if (mode.rows.size() > 0) {
        found.growthKind = growthKindOf(mode.factor);
        found.dominant = dominantEffectOf(linearised, mode.rows);
        found.points = largestMovers(linearised, mode.rows);
    }
    return found;
}

double growthOf(const Scene &scene, const State &state, const Method &method, double h)
{
    const LinearisedScene linearised = linearise(scene, state, method);
    const std::unique_ptr<StepAnalysis> analysis = stepAnalysisOf(linearised, method);
    if (!linearised.finite || analysis->stiffest() == 0.0)
        return 1.0;
    return factorPerFrame(analysis->growth(h), analysis->rounding(), h);
}

}
