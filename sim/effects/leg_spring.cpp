#include "sim/effects/leg_spring.h"

#include "sim/effects/pair_kernels.h"

#include <algorithm>
#include <tuple>

namespace sim {

template class PairForce<LegLaw>;

namespace {

const char *const here = "sim/effects/leg_spring.h";

/// Ordered by foot, and of one foot by the higher point.
std::vector<Leg> inOrder(std::vector<Leg> legs)
{
    std::stable_sort(legs.begin(), legs.end(), [](const Leg &a, const Leg &b) {
        return std::pair(a.foot, std::max(a.foot, a.body)) < std::pair(b.foot, std::max(b.foot, b.body));
    });
    return legs;
}

std::vector<Pair> pairsOf(const std::vector<Leg> &legs, Reaction reaction)
{
    std::vector<Pair> pairs;
    for (const Leg &leg : legs)
        pairs.push_back({leg.foot, leg.body, static_cast<int>(pairs.size()), reaction == Reaction::equal});
    return pairs;
}

std::vector<LegLaw::Numbers> numbersOf(const std::vector<Leg> &legs)
{
    std::vector<LegLaw::Numbers> numbers;
    for (const Leg &leg : legs)
        numbers.push_back({leg.angle, leg.clock});
    return numbers;
}

}

LegSpring::LegSpring(const std::vector<Leg> &legs, LegRule rule)
    : RestingPairForce({rule}, pairsOf(inOrder(legs), rule.reaction), numbersOf(inOrder(legs)))
{
}

std::vector<Region> LegSpring::regions(Directions) const
{
    std::vector<Region> all;
    if (rule().aim == Aim::swing)
        all.push_back({here, "gait_angle"});
    all.push_back({here, "bone_target"});
    if (rule().aim != Aim::bone)
        all.push_back({here, "below_target"});
    all.push_back({"sim/effects/spring.h", "spring"});
    if (rule().reaction == Reaction::equal)
        all.push_back(reactionShown());
    return all;
}

Vec2 LegSpring::target(const State &state, int number) const
{
    const Pair &leg = pairs().at(static_cast<std::size_t>(number));
    return law().target(state.at(leg.anchor), now(state, leg.number));
}

std::vector<Leg> LegSpring::legs() const
{
    std::vector<Leg> all;
    for (const Pair &leg : pairs()) {
        const LegLaw::Numbers &own = numbers()[static_cast<std::size_t>(leg.number)];
        all.push_back({leg.mover, leg.anchor, own.angle, own.clock});
    }
    return all;
}

std::vector<Live> LegLaw::live(Vec2 foot, Vec2 body, Vec2, const Numbers &one, Directions) const
{
    std::vector<Live> all;
    if (aim == Aim::swing)
        all.push_back({"turned", one.angle});
    const Vec2 to = target(body, one);
    const SpringPull s = spring(foot, to, k);
    all.insert(all.end(), {{"target", to}, {"d", s.d}, {"pull", s.pull}});
    return all;
}

}
