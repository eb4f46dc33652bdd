#include "app/model/analysis/tried_spot.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

double fitted(const lessons::Parameter &parameter, double value, double grid)
{
    return std::clamp(std::round(value / grid) * grid, parameter.min, parameter.max);
}

}

bool addTried(std::vector<TriedSpot> &tried, const TriedSpot &spot)
{
    constexpr std::size_t most = 400;
    if (!tried.empty() && tried.back() == spot)
        return false;
    tried.push_back(spot);
    if (tried.size() > most)
        tried.erase(tried.begin());
    return true;
}

const lessons::Parameter *stiffnessOf(const lessons::Step &step)
{
    return step.parameter(QStringLiteral("k"));
}

const lessons::Parameter *dampingOf(const lessons::Step &step)
{
    return step.parameterFor(lessons::ParameterRole::damping);
}

TriedSpot settable(const lessons::Step &step, TriedSpot spot)
{
    // Round a stiffness to three digits, because its scale is logarithmic, and damping as its field shows it.
    const lessons::Parameter *k = stiffnessOf(step), *damp = dampingOf(step);
    if (k && spot.k > 0.0)
        spot.k = fitted(*k, spot.k, std::pow(10.0, std::floor(std::log10(spot.k)) - 2.0));
    if (damp)
        spot.damp = fitted(*damp, spot.damp, std::pow(10.0, -damp->decimals));
    spot.h = spot.h < 1.0 ? 1.0 / std::round(1.0 / spot.h) : std::round(spot.h);
    return spot;
}

}
