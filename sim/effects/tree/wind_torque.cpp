#include "sim/effects/tree/wind_torque.h"

#include "sim/base/direction.h"

namespace sim {

namespace {

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

WindTorque::BranchPush WindTorque::pushOn(const State &state, int branch) const
{
    const double scale = m_tree->scaleOf(branch);
    const Vec2 along = branchReach(state.angle[branch], 1.0, degreesPerRadian);
    const Vec2 end = branchEnd(state.positionOf(branch), along, m_tree->baseLength * scale);
    const Direction heading = direction(end - *state.input.pointer, pointerIndex, branch);
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

WindTorque::PushDerivatives WindTorque::pushDerivatives(const State &state, int branch) const
{
    const auto [distance, out, share, push] = pushOn(state, branch);
    const Vec2 along = branchReach(state.angle[branch], 1.0, degreesPerRadian);
    const double scale = m_tree->scaleOf(branch), scaleSquared = scale * scale;
    const double factor = m_wind * degreesPerRadian * scaleSquared * scaleSquared / m_inertia[branch];
    const double far = std::max(distance, 100.0);
    const double strength = factor * share / far;
    const double decay = distance > 100.0 ? strength / far : 0.0;
    const double strengthDerivative =
        factor * gustDerivative(distance, state.gustExtent, m_gusts) / far - decay;
    // If the end moves across the wind, `out` turns, and the sine `turn` changes by the cosine per radian.
    const double cosine = dot(along, out);
    const double byAcross = strength * cosine / std::max(distance, coincidenceDistance);
    const Vec2 across = {-out.y, out.x};
    return {(strengthDerivative * push.turn) * out + byAcross * across,
            -strength * cosine / degreesPerRadian};
}

bool WindTorque::addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const
{
    if (!blows(state))
        return true;
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const PushDerivatives derivatives = pushDerivatives(state, i);
        jacobian.addAngular(i, i, scale * derivatives.byAngle);
        for (int branch = i; branch >= 0; branch = m_tree->parent[static_cast<std::size_t>(branch)]) {
            const double length = m_tree->baseLength * m_tree->scaleOf(branch);
            const Vec2 reach = branchReach(state.angle[branch], length, degreesPerRadian);
            const double byBranchAngle = derivatives.byEnd.y * reach.x - derivatives.byEnd.x * reach.y;
            jacobian.addAngular(i, branch, scale * byBranchAngle / degreesPerRadian);
            if (!state.isDynamic(branch)) // the learner holds its origin, so nothing below moves it
                break;
        }
    }
    return true;
}

std::vector<LiveValue> WindTorque::explain(const State &state, int mover) const
{
    if (!state.isDynamic(mover) || !blows(state))
        return {};
    const BranchPush branchPush = pushOn(state, mover);
    return {{"distance", branchPush.distance, {}}, {"out", branchPush.out, {}},
            {"share", branchPush.share, {}},       {"air", branchPush.push.air, {}},
            {"turn", branchPush.push.turn, {}},    {"pull", branchPush.push.pull, {}}};
}

}
