#include "sim/effects/tree/wind_torque.h"

#include "sim/base/direction.h"

namespace sim {

namespace {

/// The pointer has no number among the points.
constexpr int pointerNumber = -1;

bool blows(const State &state)
{
    return state.input.pointer && state.gustExtent.front > 0.0;
}

}

std::vector<Region> WindTorque::regions(DirectionRule) const
{
    return {{"sim/effects/tree/wind_torque.h", "wind_push"},
            {"sim/effects/drivers/gust.h", "gust_at"},
            {"sim/base/direction.h", "direction"}};
}

int WindTorque::count(const State &, PointRange points) const
{
    return points.count;
}

WindTorque::Found WindTorque::pushOn(const State &state, int branch) const
{
    const double scale = m_tree->scale[static_cast<std::size_t>(branch)];
    const Vec2 along = branchReach(state.angle[branch], 1.0, degreesPerRadian);
    const Vec2 end = branchEnd(state.positionOf(branch), along, m_tree->baseLength * scale);
    const Direction heading = direction(end - *state.input.pointer, pointerNumber, branch);
    const double share = gustAt(heading.length, state.gustExtent, m_gusts);
    return {heading.length, heading.out, share,
            windPush(heading.out, along, heading.length, m_wind, share, scale, m_inertia[branch])};
}

void WindTorque::add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const
{
    if (!blows(state))
        return;
    for (int i = movers.first; i < movers.end(); ++i) {
        if (state.isDynamic(i))
            into[i] += scale * pushOn(state, i).push.pull;
    }
}

/// How the push on `branch` changes with where its end is (degrees/frame^2 a px), and with its direction alone
/// (1/frame^2): the derivatives of windPush(), whose push is a strength by the distance times the sine `turn`.
WindTorque::Change WindTorque::changeOf(const State &state, int branch) const
{
    const auto [distance, out, share, push] = pushOn(state, branch);
    const Vec2 along = branchReach(state.angle[branch], 1.0, degreesPerRadian);
    const double scale = m_tree->scale[static_cast<std::size_t>(branch)], side = scale * scale;
    const double times = m_wind * degreesPerRadian * side * side / m_inertia[branch];
    const double far = std::max(distance, 100.0);
    const double strength = times * share / far;
    const double nearer = distance > 100.0 ? strength / far : 0.0;
    const double farther = times * gustDerivative(distance, state.gustExtent, m_gusts) / far - nearer;
    // across the wind the push turns with it: along x (out by a px across) is along . out
    const double facing = dot(along, out);
    const double turns = strength * facing / std::max(distance, 1e-150);
    const Vec2 across = {-out.y, out.x};
    return {(farther * push.turn) * out + turns * across, -strength * facing / degreesPerRadian};
}

bool WindTorque::addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const
{
    if (!blows(state))
        return true;
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const Change change = changeOf(state, i);
        jacobian.addAngular(i, i, scale * change.byTurning);
        for (int branch = i; branch >= 0; branch = m_tree->parent[static_cast<std::size_t>(branch)]) {
            const double length = m_tree->baseLength * m_tree->scale[static_cast<std::size_t>(branch)];
            const Vec2 reach = branchReach(state.angle[branch], length, degreesPerRadian);
            const double turned = change.byEnd.y * reach.x - change.byEnd.x * reach.y;
            jacobian.addAngular(i, branch, scale * turned / degreesPerRadian);
            if (!state.isDynamic(branch)) // a hand holds its origin
                break;
        }
    }
    return true;
}

std::vector<LiveValue> WindTorque::explain(const State &state, int mover) const
{
    if (!state.isDynamic(mover) || !blows(state))
        return {};
    const Found found = pushOn(state, mover);
    return {{"distance", found.distance, {}}, {"out", found.out, {}},        {"share", found.share, {}},
            {"air", found.push.air, {}},      {"turn", found.push.turn, {}}, {"pull", found.push.pull, {}}};
}

}
