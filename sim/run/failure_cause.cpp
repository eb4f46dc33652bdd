#include "sim/run/failure_cause.h"

#include <cmath>
#include <limits>

namespace sim {

namespace {

/// Returns the magnitude of the last explained value of a force, which is its pull; infinity if it is not
/// finite.
double magnitudeOf(const std::vector<LiveValue> &live)
{
    if (live.empty())
        return 0.0;
    const auto *pull = std::get_if<Vec2>(&live.back().value);
    const double magnitude = pull ? length(*pull) : std::abs(std::get<double>(live.back().value));
    return std::isfinite(magnitude) ? magnitude : std::numeric_limits<double>::infinity();
}

EffectPtr strongestForceOn(int point, const Scene &scene, const State &before, DirectionRule directionRule)
{
    EffectPtr strongest;
    double largest = 0.0;
    for (const EffectPtr &effect : scene.effects) {
        const auto *force = as<Force>(effect);
        if (!force || force->count(before, {point, 1}) == 0)
            continue;
        const double magnitude = magnitudeOf(force->explain(before, point, directionRule));
        if (magnitude > largest) {
            largest = magnitude;
            strongest = effect;
        }
    }
    return strongest;
}

/// Returns the other point on which `force` at `point` depends most, or -1. The measure is the derivative
/// times the distance along its axis.
int otherEnd(const Force &force, const State &before, int point, DirectionRule directionRule)
{
    const int points = before.pointCount();
    Jacobian jacobian(points);
    if (!force.addJacobian(before, {point, 1}, 1.0, directionRule, jacobian))
        return -1;
    int other = -1;
    double largest = 0.0;
    for (const Jacobian::Entry &entry : jacobian.entries()) {
        const int source = entry.column % points;
        if (entry.row % points != point || source == point || entry.column >= 2 * points)
            continue;
        const int axis = entry.column / points;
        const double distance = before.position(source, axis) - before.position(point, axis);
        const double pull = std::abs(entry.value * distance);
        if (pull > largest) {
            largest = pull;
            other = source;
        }
    }
    return other;
}

}

FailureCause failureCauseOf(const Phase &phase, const Scene &scene, const State &before, int point,
                            DirectionRule directionRule)
{
    FailureCause cause;
    cause.effect =
        phase.effect || point < 0 ? phase.effect : strongestForceOn(point, scene, before, directionRule);
    if (const auto *force = as<Force>(cause.effect); force && point >= 0)
        cause.other = otherEnd(*force, before, point, directionRule);
    return cause;
}

}
