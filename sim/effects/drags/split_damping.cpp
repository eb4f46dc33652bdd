#include "sim/effects/drags/split_damping.h"

#include <cmath>

namespace sim {

std::vector<Region> SplitDamping::regions(DirectionRule) const
{
    return {{"sim/effects/drags/split_damping.h", "split_damping"}, {"sim/base/direction.h", "direction"}};
}

int SplitDamping::count(const State &state, PointRange points) const
{
    return points.contains(m_mover) && state.isDynamic(m_mover) ? 1 : 0;
}

SplitVelocity SplitDamping::split(const State &state, double h) const
{
    const Vec2 out = direction(state.positionOf(m_anchor) - state.positionOf(m_mover), m_mover, m_anchor).out;
    return dampSplit(state.velocityOf(m_mover), out, std::pow(m_along, h), std::pow(m_across, h));
}

void SplitDamping::apply(State &state, PointRange points, double h) const
{
    if (count(state, points) > 0)
        state.setVelocity(m_mover, split(state, h).v);
}

std::vector<LiveValue> SplitDamping::explain(const State &before, const State &after, int point,
                                             double h) const
{
    if (point != m_mover || !before.isDynamic(point))
        return {};
    const SplitVelocity parts = split(before, h);
    return {{"parallel", parts.parallel},
            {"sideways", parts.sideways},
            {"v", after.velocityOf(point), before.velocityOf(point)}};
}

namespace descriptions {
constinit const EffectDescription split_damping = {
    "split_damping", SIM_TEXT("drag along, across"), EffectKind::damping,
    SIM_TEXT("Slows the tail as water does: more across the body than along it.")};
}

}
