#include "sim/analysis/cost/affected_points.h"

#include <algorithm>

namespace sim {

namespace {

/// Halves what has something to do until it knows where: most effects find out about few points at once quickly.
void mark(const Effect &effect, const State &state, PointRange among, std::vector<char> &movers)
{
    if (among.count == 0 || effect.count(state, among) == 0)
        return;
    if (among.count == 1) {
        movers[static_cast<std::size_t>(among.first)] = 1;
        return;
    }
    const int half = among.count / 2;
    mark(effect, state, {among.first, half}, movers);
    mark(effect, state, {among.first + half, among.count - half}, movers);
}

void markPulled(const Force &force, const State &state, DirectionRule directionRule,
                std::vector<char> &touched)
{
    Eigen::ArrayX2d pulls = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    force.add(state, {0, state.pointCount()}, 1.0, directionRule, pulls);
    for (int i = 0; i < state.pointCount(); ++i) {
        if (pulls(i, 0) != 0.0 || pulls(i, 1) != 0.0)
            touched[static_cast<std::size_t>(i)] = 1;
    }
}

void markTied(const Effect &effect, const State &state, std::vector<char> &touched)
{
    std::vector<Coupling> ties;
    effect.addCouplings(ties);
    for (const auto &[one, other] : ties) {
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
        markPulled(*force, state, directionRule, touched);
    if (force ? force->conservesMomentum(state) : as<Constraint>(effect) != nullptr)
        markTied(effect, state, touched);
    return static_cast<int>(std::count(touched.begin(), touched.end(), 1));
}

}
