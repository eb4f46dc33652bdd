#include "sim/effects/radial_spring.h"

#include "sim/effects/pull_runs.h"

namespace sim {

template <class HeadingOf>
Vec2 RadialSpring::pullOf(const State &state, const Link &link, HeadingOf direction) const
{
    return radialSpring(state.at(link.mover), state.at(link.anchor), m_k, m_radius, direction).end.pull;
}

std::vector<Region> RadialSpring::regions(Directions directions) const
{
    const std::string way = directions == Directions::published ? "published_direction" : "direction";
    return {{"sim/effects/radial_spring.h", "radial_spring"},
            {"sim/direction.h", way},
            {"sim/effects/spring.h", "spring"}};
}

void RadialSpring::add(const State &state, Points movers, double scale, Directions directions,
                       Eigen::ArrayX2d &into) const
{
    if (directions == Directions::apart) {
        addRuns(Take::movers, state, movers, scale, into);
        return;
    }
    addPulls(m_links, state, movers, scale, into, [&](const Link &link) {
        return pullOf(state, link, [](Vec2 d) { return publishedDirection(d).out; });
    });
}

void RadialSpring::addPart(const State &state, Points part, double scale, Directions directions,
                           Eigen::ArrayX2d &into) const
{
    if (directions == Directions::apart)
        addRuns(Take::part, state, part, scale, into);
    else
        add(state, part, scale, directions, into);
}

void RadialSpring::addRuns(Take take, const State &state, Points points, double scale,
                           Eigen::ArrayX2d &into) const
{
    // The way back is the same way turned round, so what takes long is computed once.
    const auto both = [k = m_k, radius = m_radius](Vec2 mover, Vec2 anchor) {
        Heading way;
        const auto there = [&](Vec2 d) { return (way = direction(d)).out; };
        const auto back = [&](Vec2) { return Vec2{-way.out.x, -way.out.y}; };
        const Vec2 pull = radialSpring(mover, anchor, k, radius, there).end.pull;
        return BothPulls{pull, radialSpring(anchor, mover, k, radius, back).end.pull, way.length};
    };
    addPullRuns(m_links, take, state, points, scale, into, both, [&](const Link &link) {
        return pullOf(state, link, [&](Vec2 d) { return direction(d, link.anchor, link.mover).out; });
    });
}

bool RadialSpring::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    addPullSlopes(m_links, state, movers, scale, into, [&](const Link &link) {
        return slopeToDistance(state.at(link.mover) - state.at(link.anchor), m_k, m_radius);
    });
    return true;
}

std::optional<double> RadialSpring::energy(const State &state) const
{
    return m_links.stored(state, [&](const Link &link) {
        const double stretch = length(state.at(link.mover) - state.at(link.anchor)) - m_radius;
        return 0.5 * m_k * stretch * stretch;
    });
}

bool RadialSpring::balances(const State &state) const
{
    return m_links.balance(state);
}

std::vector<Live> RadialSpring::explain(const State &state, int mover, Directions directions) const
{
    return explainLinks(m_links, state, mover, [&](const Link &link) {
        std::vector<Live> heading;
        const RadialPull s =
            radialSpring(state.at(link.mover), state.at(link.anchor), m_k, m_radius, [&](Vec2 d) {
                if (directions == Directions::published) {
                    const PublishedHeading found = publishedDirection(d);
                    heading = {{"angle", found.angle}, {"out", found.out}};
                    return found.out;
                }
                const Heading found = direction(d, link.anchor, link.mover);
                heading = {{"length", found.length}, {"out", found.out}};
                return found.out;
            });
        std::vector<Live> all = {{"from", s.from}};
        all.insert(all.end(), heading.begin(), heading.end());
        all.insert(all.end(), {{"target", s.target}, {"d", s.end.d}, {"pull", s.end.pull}});
        return all;
    });
}

void RadialSpring::rests(const State &state, std::vector<RestEnd> &into) const
{
    for (const Link &link : m_links.list())
        into.push_back(restAt(state, link.mover, link.anchor, m_radius));
}

}
