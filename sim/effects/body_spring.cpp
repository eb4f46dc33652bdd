#include "sim/effects/body_spring.h"

#include "sim/effects/spring.h"

namespace sim {

std::vector<Region> BodySpring::regions(Directions) const
{
    return {{"sim/effects/spring.h", "spring"}};
}

void BodySpring::add(const State &state, Points movers, double scale, Directions, Eigen::ArrayX2d &into) const
{
    addPulls(m_links, state, movers, scale, into,
             [&](const Link &link) { return spring(state.at(link.mover), state.at(link.anchor), m_k).pull; });
}

bool BodySpring::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    addPullSlopes(m_links, state, movers, scale, into, [&](const Link &) { return slopeToPlace(m_k); });
    return true;
}

std::optional<double> BodySpring::energy(const State &state) const
{
    return m_links.stored(state, [&](const Link &link) {
        return springEnergy(state.at(link.anchor) - state.at(link.mover), m_k);
    });
}

bool BodySpring::balances(const State &state) const
{
    return m_links.balance(state);
}

std::vector<Live> BodySpring::explain(const State &state, int mover, Directions) const
{
    return explainLinks(m_links, state, mover, [&](const Link &link) -> std::vector<Live> {
        const SpringPull s = spring(state.at(link.mover), state.at(link.anchor), m_k);
        return {{"d", s.d}, {"pull", s.pull}};
    });
}

}
