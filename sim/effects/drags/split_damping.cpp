#include "sim/effects/drags/split_damping.h"

#include <cmath>

namespace sim {

std::vector<Region> SplitDamping::regions(Directions) const
{
    return {{"sim/effects/drags/split_damping.h", "split_damping"}, {"sim/base/direction.h", "direction"}};
}

int SplitDamping::count(const State &state, Points points) const
{
    return points.contains(m_mover) && state.feels(m_mover) ? 1 : 0;
}

SplitVelocity SplitDamping::split(const State &state, double h) const
{
    const Vec2 out = direction(state.at(m_anchor) - state.at(m_mover), m_mover, m_anchor).out;
    return dampSplit(state.speed(m_mover), out, std::pow(m_along, h), std::pow(m_across, h));
}

void SplitDamping::slow(State &state, Points points, double h) const
{
    if (count(state, points) > 0)
        state.push(m_mover, split(state, h).v);
}

std::vector<Live> SplitDamping::explain(const State &before, const State &after, int point, double h) const
{
    if (point != m_mover || !before.feels(point))
        return {};
    const SplitVelocity parts = split(before, h);
    return {{"parallel", parts.parallel},
            {"sideways", parts.sideways},
            {"v", after.speed(point), before.speed(point)}};
}

namespace described {
constinit const Description split_damping = {
    "split_damping", SIM_TEXT("drag along, across"), Kind::damping,
    SIM_TEXT("Slows the tail, and more so across the body than along it, as water does.")};
}

}
