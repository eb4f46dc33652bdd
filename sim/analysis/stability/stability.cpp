#include "sim/analysis/stability/stability.h"

#include "sim/analysis/stability/modes/step_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr double littlePast =
    1.02; ///< times the limit: where what grows first can be told from what does not

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

/// From a logarithm a step to a factor a frame. What rounding may have done is no growth.
double aFrame(double growth, double rounding, double h)
{
    const double factor = std::exp(growth / h);
    return growth <= rounding ? std::min(1.0, factor) : factor;
}

/// What a pattern does from step to step: its factor's direction in the plane tells.
GrowthKind mannerOf(std::complex<double> factor)
{
    if (std::abs(factor.imag()) > 1e-6 * std::abs(factor))
        return GrowthKind::oscillating;
    return factor.real() < 0.0 ? GrowthKind::alternating : GrowthKind::monotonic;
}

/// A step at which what decides can be seen: the one in use if it grows there, else one just past the limit.
double tellingStep(const Stability &found)
{
    if (found.growth > 1.0 || !std::isfinite(found.limit) || found.limit <= 0.0)
        return found.h;
    return littlePast * found.limit;
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
    found.growth = aFrame(analysis->growth(h), analysis->rounding(), h);
    found.limit = analysis->limit();
    const Mode mode = analysis->dominantMode(tellingStep(found));
    if (mode.rows.size() > 0) {
        found.growthKind = mannerOf(mode.factor);
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
    return aFrame(analysis->growth(h), analysis->rounding(), h);
}

}
