#include "sim/analysis/cost/affected_points.h"

#include <algorithm>

namespace sim {

namespace {

/// Sets `movers` to 1 at each point of `range` for which the effect computes anything. Halves the range until
/// single points are left, because most effects count few points quickly.
void mark(const Effect &effect, const State &state, PointRange range, std::vector<char> &movers)
{
    if (range.count == 0 || effect.count(state, range) == 0)
        return;
    if (range.count == 1) {
        movers[static_cast<std::size_t>(range.first)] = 1;
        return;
    }
    const int half = range.count / 2;
    mark(effect, state, {range.first, half}, movers);
    mark(effect, state, {range.first + half, range.count - half}, movers);
}

void markAccelerated(const Force &force, const State &state, DirectionRule directionRule,
                     std::vector<char> &touched)
{
    Eigen::ArrayX2d acceleration = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    force.add(state, {0, state.pointCount()}, 1.0, directionRule, acceleration);
    for (int i = 0; i < state.pointCount(); ++i) {
        if (acceleration(i, 0) != 0.0 || acceleration(i, 1) != 0.0)
            touched[static_cast<std::size_t>(i)] = 1;
    }
}

void markCoupled(const Effect &effect, const State &state, std::vector<char> &touched)
{
    std::vector<Coupling> couplings;
    effect.addCouplings(couplings);
    for (const auto &[one, other] : couplings) {
        for (const int end : {one, other}) {
            if (state.isDynamic(end))
                touched[static_cast<std::size_t>(end)] = 1;
        }
    }
}

}

std::vector<char> affectedPoints(const Effect &effect, const State &state)
{
    std::vector<char> movers(static_cast<std::size_t>(state.pointCount()), 0);
    mark(effect, state, {0, state.pointCount()}, movers);
    return movers;
}

int pointsOf(const Effect &effect, const State &state, const std::vector<char> &movers,
             DirectionRule directionRule)
{
    std::vector<char> touched = movers;
    const auto *force = as<Force>(effect);
    if (force)
        markAccelerated(*force, state, directionRule, touched);
    if (force ? force->conservesMomentum(state) : as<Constraint>(effect) != nullptr)
        markCoupled(effect, state, touched);
    return static_cast<int>(std::count(touched.begin(), touched.end(), 1));
}

}
