#include "sim/run/failure_cause.h"

#include <cmath>
#include <limits>

namespace sim {

namespace {

/// How large what `force` last says about itself is, its pull; infinite where that is not finite.
double sizeOf(const std::vector<LiveValue> &live)
{
    if (live.empty())
        return 0.0;
    const auto *pull = std::get_if<Vec2>(&live.back().value);
    const double size = pull ? length(*pull) : std::abs(std::get<double>(live.back().value));
    return std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
}

EffectPtr hardestOn(int point, const Scene &scene, const State &before, DirectionRule directionRule)
{
    EffectPtr hardest;
    double most = 0.0;
    for (const EffectPtr &effect : scene.effects) {
        const auto *force = as<Force>(effect);
        if (!force || force->count(before, {point, 1}) == 0)
            continue;
        const double size = sizeOf(force->explain(before, point, directionRule));
        if (size > most) {
            most = size;
            hardest = effect;
        }
    }
    return hardest;
}

/// The point whose place `force` on `point` depends on most, by how far it is along the axis; -1 where there is none.
int otherEnd(const Force &force, const State &before, int point, DirectionRule directionRule)
{
    const int points = before.pointCount();
    Jacobian jacobian(points);
    if (!force.addJacobian(before, {point, 1}, 1.0, directionRule, jacobian))
        return -1;
    int other = -1;
    double most = 0.0;
    for (const Jacobian::Entry &one : jacobian.entries()) {
        const int by = one.column % points;
        if (one.row % points != point || by == point || one.column >= 2 * points)
            continue;
        const int axis = one.column / points;
        const double pull = std::abs(one.value * (before.position(by, axis) - before.position(point, axis)));
        if (pull > most) {
            most = pull;
            other = by;
        }
    }
    return other;
}

}

FailureCause failureCauseOf(const Phase &phase, const Scene &scene, const State &before, int point,
                            DirectionRule directionRule)
{
    FailureCause cause;
    cause.effect = phase.effect || point < 0 ? phase.effect : hardestOn(point, scene, before, directionRule);
    if (const auto *force = as<Force>(cause.effect); force && point >= 0)
        cause.other = otherEnd(*force, before, point, directionRule);
    return cause;
}

}
