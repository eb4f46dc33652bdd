#include "sim/effects/wind_torque.h"

#include "sim/direction.h"

namespace sim {

namespace {

/// The pointer has no number among the points.
constexpr int pointerNumber = -1;

bool blows(const State &state)
{
    return state.outside.pointer && state.gale.front > 0.0;
}

}

std::vector<Region> WindTorque::regions(Directions) const
{
    return {{"sim/effects/wind_torque.h", "wind_push"},
            {"sim/effects/gust.h", "gust_at"},
            {"sim/direction.h", "direction"}};
}

int WindTorque::count(const State &, Points points) const
{
    return points.count;
}

WindTorque::Found WindTorque::pushOn(const State &state, int branch) const
{
    const double scale = m_tree->scale[static_cast<std::size_t>(branch)];
    const Vec2 along = branchReach(state.angle[branch], 1.0, degreesPerRadian);
    const Vec2 end = branchEnd(state.at(branch), along, m_tree->baseLength * scale);
    const Heading heading = direction(end - *state.outside.pointer, pointerNumber, branch);
    const double share = gustAt(heading.length, state.gale, m_gusts);
    return {heading.length, heading.out, share,
            windPush(heading.out, along, heading.length, m_wind, share, scale, m_inertia[branch])};
}

void WindTorque::add(const State &state, Points movers, double scale, Eigen::ArrayXd &into) const
{
    if (!blows(state))
        return;
    for (int i = movers.first; i < movers.end(); ++i) {
        if (state.feels(i))
            into[i] += scale * pushOn(state, i).push.pull;
    }
}

std::vector<Live> WindTorque::explain(const State &state, int mover) const
{
    if (!state.feels(mover) || !blows(state))
        return {};
    const Found found = pushOn(state, mover);
    return {{"distance", found.distance, {}}, {"out", found.out, {}},        {"share", found.share, {}},
            {"air", found.push.air, {}},      {"turn", found.push.turn, {}}, {"pull", found.push.pull, {}}};
}

}
