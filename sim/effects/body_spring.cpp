#include "sim/effects/body_spring.h"

#include "sim/effects/pull_runs.h"
#include "sim/effects/spring.h"

namespace sim {

std::vector<Region> BodySpring::regions(Directions) const
{
    return {{"sim/effects/spring.h", "spring"}};
}

void BodySpring::add(const State &state, Points movers, double scale, Directions, Eigen::ArrayX2d &into) const
{
    const auto both = [k = m_k](Vec2 mover, Vec2 anchor) {
        return BothPulls{spring(mover, anchor, k).pull, spring(anchor, mover, k).pull};
    };
    addPullRuns(m_links, state, movers, scale, into, both);
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
