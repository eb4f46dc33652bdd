#include "sim/effects/offset_spring.h"

#include "sim/effects/pull_runs.h"
#include "sim/effects/spring.h"

namespace sim {

std::vector<Region> OffsetSpring::regions(Directions) const
{
    return {{"sim/effects/offset_spring.h", "offset_target"}, {"sim/effects/spring.h", "spring"}};
}

void OffsetSpring::add(const State &state, Points movers, double scale, Directions,
                       Eigen::ArrayX2d &into) const
{
    const auto both = [k = m_k, offset = m_offset](Vec2 mover, Vec2 anchor) {
        return BothPulls{spring(mover, offsetTarget(anchor, offset), k).pull,
                         spring(anchor, offsetTarget(mover, offset), k).pull};
    };
    addPullRuns(m_links, state, movers, scale, into, both);
}

bool OffsetSpring::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    addPullSlopes(m_links, state, movers, scale, into, [&](const Link &) { return slopeToPlace(m_k); });
    return true;
}

std::optional<double> OffsetSpring::energy(const State &state) const
{
    if (!m_links.areTied(state))
        return {}; // to and fro, both are pulled to the right
    return m_links.stored(state, [&](const Link &link) {
        return springEnergy(offsetTarget(state.at(link.anchor), m_offset) - state.at(link.mover), m_k);
    });
}

std::vector<Live> OffsetSpring::explain(const State &state, int mover, Directions) const
{
    return explainLinks(m_links, state, mover, [&](const Link &link) -> std::vector<Live> {
        const Vec2 target = offsetTarget(state.at(link.anchor), m_offset);
        const SpringPull s = spring(state.at(link.mover), target, m_k);
        return {{"target", target}, {"d", s.d}, {"pull", s.pull}};
    });
}

void OffsetSpring::rests(const State &state, std::vector<RestEnd> &into) const
{
    for (const Link &link : m_links.list())
        into.push_back({link.mover, link.anchor, offsetTarget(state.at(link.anchor), m_offset), false});
}

}
