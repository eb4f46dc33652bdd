#include "sim/effects/push.h"

#include "sim/effects/pair_kernels.h"

#include <algorithm>

namespace sim {

template class PairForce<PushLaw>;

namespace {

/// Every two of `points`, the one with the lower number as the mover.
std::vector<Pair> everyTwo(std::vector<int> points, Reaction reaction)
{
    std::sort(points.begin(), points.end());
    std::vector<Pair> pairs;
    for (auto one = points.begin(); one != points.end(); ++one) {
        for (auto other = std::next(one); other != points.end(); ++other)
            pairs.push_back({*one, *other, 0, reaction == Reaction::equal});
    }
    return pairs;
}

}

Push::Push(std::vector<int> points, double k, double distance, Reaction reaction)
    : PairForce({k, distance}, everyTwo(points, reaction), {{}}), m_points(std::move(points)),
      m_reaction(reaction)
{
    std::sort(m_points.begin(), m_points.end());
}

std::vector<Region> Push::regions(Directions directions) const
{
    const std::string way = directions == Directions::published ? "published_direction" : "direction";
    std::vector<Region> all = {{"sim/effects/push.h", "push"}, {"sim/direction.h", way}};
    if (m_reaction == Reaction::equal)
        all.push_back(reactionShown());
    return all;
}

std::vector<Live> PushLaw::live(Vec2 one, Vec2 other, Vec2 parting, const Numbers &,
                                Directions directions) const
{
    const PushPull found = push(one, other, k, distance, [&](Vec2 d) {
        if (directions == Directions::published)
            return publishedHeading(d);
        const Heading heading = direction(d);
        return heading.length < inOnePlace ? Heading{heading.length, parting} : heading;
    });
    return {{"from", found.from}, {"missing", found.missing}, {"pull", found.pull}};
}

}
