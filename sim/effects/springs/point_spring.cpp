#include "sim/effects/springs/point_spring.h"

#include "sim/effects/pairs/pair_jacobian.h"
#include "sim/effects/pairs/spring.h"
#include "sim/scene/blueprint_draft.h"

namespace sim {

std::vector<Region> PointSpring::regions(DirectionRule) const
{
    return {{"sim/effects/pairs/spring.h", "spring"}};
}

int PointSpring::count(const State &state, PointRange points) const
{
    return points.contains(m_mover) && state.isDynamic(m_mover) ? 1 : 0;
}

void PointSpring::add(const State &state, PointRange movers, double scale, DirectionRule,
                      Eigen::ArrayX2d &into) const
{
    if (count(state, movers) == 0)
        return;
    const Vec2 a = state.inverseMass[m_mover] * spring(state.positionOf(m_mover), m_centre, m_k).pull;
    into(m_mover, 0) += scale * a.x;
    into(m_mover, 1) += scale * a.y;
}

bool PointSpring::addJacobian(const State &state, PointRange movers, double scale, DirectionRule,
                              Jacobian &jacobian) const
{
    if (count(state, movers) > 0)
        addJacobianBlock(jacobian, m_mover, m_mover,
                         (scale * state.inverseMass[m_mover]) * pointSpringJacobian(m_k));
    return true;
}

std::optional<double> PointSpring::potentialEnergy(const State &state) const
{
    return state.isDynamic(m_mover) ? springEnergy(length(m_centre - state.positionOf(m_mover)), m_k) : 0.0;
}

bool PointSpring::addToDraft(BlueprintDraft &draft) const
{
    draft.addSpring({m_mover, draft.addFixedPoint("centre", m_centre), m_k, 0.0}, true);
    return true;
}

std::vector<LiveValue> PointSpring::explain(const State &state, int mover, DirectionRule) const
{
    if (count(state, {mover, 1}) == 0)
        return {};
    const SpringPull s = spring(state.positionOf(mover), m_centre, m_k);
    return {{"d", s.d}, {"pull", state.inverseMass[mover] * s.pull}};
}

namespace descriptions {
constinit const EffectDescription point_spring = {"point_spring", SIM_TEXT("spring"), EffectKind::spring,
                                                  SIM_TEXT("Pulls a foot to a fixed place.")};
}

}
