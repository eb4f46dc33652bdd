#include "sim/effects/springs/point_spring.h"

#include "sim/effects/pairs/pair_jacobian.h"
#include "sim/effects/pairs/spring.h"
#include "sim/scene/blueprint_draft.h"

namespace sim {

std::vector<Region> PointSpring::regions(Directions) const
{
    return {{"sim/effects/pairs/spring.h", "spring"}};
}

int PointSpring::count(const State &state, Points points) const
{
    return points.contains(m_mover) && state.feels(m_mover) ? 1 : 0;
}

void PointSpring::add(const State &state, Points movers, double scale, Directions,
                      Eigen::ArrayX2d &into) const
{
    if (count(state, movers) == 0)
        return;
    const Vec2 a = state.inverseMass[m_mover] * spring(state.at(m_mover), m_centre, m_k).pull;
    into(m_mover, 0) += scale * a.x;
    into(m_mover, 1) += scale * a.y;
}

bool PointSpring::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    if (count(state, movers) > 0)
        addSlope(into, m_mover, m_mover, (scale * state.inverseMass[m_mover]) * slopeToPlace(m_k));
    return true;
}

std::optional<double> PointSpring::energy(const State &state) const
{
    return state.feels(m_mover) ? springEnergy(length(m_centre - state.at(m_mover)), m_k) : 0.0;
}

bool PointSpring::takeInto(Taken &into) const
{
    into.addSpring({m_mover, into.addNail("centre", m_centre), m_k, 0.0}, true);
    return true;
}

std::vector<Live> PointSpring::explain(const State &state, int mover, Directions) const
{
    if (count(state, {mover, 1}) == 0)
        return {};
    const SpringPull s = spring(state.at(mover), m_centre, m_k);
    return {{"d", s.d}, {"pull", state.inverseMass[mover] * s.pull}};
}

namespace described {
constinit const Description point_spring = {"point_spring", SIM_TEXT("spring"), Kind::spring,
                                            SIM_TEXT("Pulls a foot to a fixed place.")};
}

}
