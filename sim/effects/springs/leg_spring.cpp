#include "sim/effects/springs/leg_spring.h"

#include "sim/effects/pairs/pair_kernels.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace sim {

template class PairForce<LegLaw>;

namespace {

const char *const sourceFile = "sim/effects/springs/leg_spring.h";

/// Returns `legs` sorted by foot, and legs of the same foot by their highest point.
std::vector<Leg> sortedByFoot(std::vector<Leg> legs)
{
    std::stable_sort(legs.begin(), legs.end(), [](const Leg &a, const Leg &b) {
        return std::pair(a.foot, std::max(a.foot, a.body)) < std::pair(b.foot, std::max(b.foot, b.body));
    });
    return legs;
}

std::vector<PointPair> pairsOf(const std::vector<Leg> &legs, Reaction reaction)
{
    std::vector<PointPair> pairs;
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
    : DescribedEffect({rule}, pairsOf(sortedByFoot(legs), rule.reaction), numbersOf(sortedByFoot(legs)))
{
}

std::vector<Region> LegLaw::regions(DirectionRule) const
{
    std::vector<Region> all;
    if (aim == Aim::swing)
        all.push_back({sourceFile, "gait_angle"});
    all.push_back({sourceFile, "bone_target"});
    if (aim != Aim::bone)
        all.push_back({sourceFile, "below_target"});
    all.push_back({"sim/effects/pairs/spring.h", "spring"});
    return all;
}

Vec2 LegSpring::target(const State &state, int index) const
{
    const PointPair &leg = links().at(static_cast<std::size_t>(index));
    return law().target(state.positionOf(leg.anchor), currentNumbers(state, leg.index));
}

std::vector<Leg> LegSpring::legs() const
{
    std::vector<Leg> all;
    for (const PointPair &leg : links()) {
        const LegLaw::Numbers &legNumbers = numbers()[static_cast<std::size_t>(leg.index)];
        all.push_back({leg.mover, leg.anchor, legNumbers.angle, legNumbers.clock});
    }
    return all;
}

std::vector<LiveValue> LegLaw::liveValues(Vec2 foot, Vec2 body, Vec2, const Numbers &numbers,
                                          DirectionRule) const
{
    std::vector<LiveValue> all;
    if (aim == Aim::swing)
        all.push_back({"turned", numbers.angle});
    const Vec2 aimedAt = target(body, numbers);
    const SpringPull s = spring(foot, aimedAt, k);
    all.insert(all.end(), {{"target", aimedAt}, {"d", s.d}, {"pull", s.pull}});
    return all;
}

namespace {

/// Returns the gait of the legs that gait clock `clock` turns, as the clock is in `state`.
BlueprintGait gaitOf(const LegRule &rule, int clock, const State &state)
{
    BlueprintGait gait;
    gait.k = rule.k;
    gait.leg = rule.leg;
    gait.drop = rule.aim == Aim::bone ? 0.0 : rule.drop;
    gait.pullsBody = rule.reaction == Reaction::equal;
    if (rule.aim == Aim::swing && clock < state.gait.rows()) {
        gait.start = state.gait[clock];
        gait.speed = state.gaitSpeed[clock];
    }
    return gait;
}

}

bool LegSpring::addToDraft(BlueprintDraft &draft) const
{
    const std::vector<int> existingFeet = feetOf(draft.blueprint);
    std::set<int> feet(existingFeet.begin(), existingFeet.end());
    std::vector<BlueprintGait> &gaits = draft.blueprint.gaits;
    std::map<int, int> groups; // by clock
    for (const Leg &leg : legs()) {
        if (!feet.insert(leg.foot).second) {
            draft.omit(SIM_TEXT("feet with more than one leg"));
            continue;
        }
        const auto [group, isNew] = groups.emplace(leg.clock, static_cast<int>(gaits.size()));
        if (isNew)
            gaits.push_back(gaitOf(rule(), leg.clock, draft.state));
        draft.blueprint.feet.push_back(
            {leg.foot, leg.body, leg.angle * 180.0 / std::numbers::pi, group->second});
    }
    return true;
}

namespace descriptions {
constinit const EffectDescription leg_spring = {
    "leg_spring", SIM_TEXT("legs"), EffectKind::spring,
    SIM_TEXT("Pull each foot to its own place, as seen from the body.")};
}

}
