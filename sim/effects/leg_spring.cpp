#include "sim/effects/leg_spring.h"

#include "sim/effects/slope.h"
#include "sim/effects/spring.h"

#include <algorithm>

namespace sim {

namespace {

const char *const here = "sim/effects/leg_spring.h";

double gaitOf(const State &state, const Leg &leg)
{
    return state.gait[leg.clock];
}

int lastOf(const Leg &leg)
{
    return std::max(leg.foot, leg.body);
}

void addTo(Eigen::ArrayX2d &into, int point, Vec2 a)
{
    into(point, 0) += a.x;
    into(point, 1) += a.y;
}

}

LegSpring::LegSpring(std::vector<Leg> legs, LegRule rule) : m_legs(std::move(legs)), m_rule(rule)
{
    std::stable_sort(m_legs.begin(), m_legs.end(), [](const Leg &a, const Leg &b) {
        return std::pair(a.foot, lastOf(a)) < std::pair(b.foot, lastOf(b));
    });
    m_byLast = m_legs;
    std::stable_sort(m_byLast.begin(), m_byLast.end(),
                     [](const Leg &a, const Leg &b) { return lastOf(a) < lastOf(b); });
}

std::vector<Region> LegSpring::regions(Directions) const
{
    std::vector<Region> all;
    if (m_rule.aim == Aim::swing)
        all.push_back({here, "gait_angle"});
    all.push_back({here, "bone_target"});
    if (m_rule.aim != Aim::bone)
        all.push_back({here, "below_target"});
    all.push_back({"sim/effects/spring.h", "spring"});
    if (m_rule.reaction == Reaction::equal)
        all.push_back(reactionShown());
    return all;
}

/// Calls `visit(leg)` for each leg whose foot is in `feet` and whose pull something feels.
template <class Visit>
void LegSpring::forEach(const State &state, Points feet, Visit &&visit) const
{
    const auto before = [](const Leg &leg, int point) { return leg.foot < point; };
    auto leg = std::lower_bound(m_legs.begin(), m_legs.end(), feet.first, before);
    for (; leg != m_legs.end() && leg->foot < feet.end(); ++leg) {
        if (state.feels(leg->foot) || bodyFeels(state, *leg))
            visit(*leg);
    }
}

int LegSpring::count(const State &state, Points points) const
{
    int total = 0;
    forEach(state, points, [&](const Leg &) { ++total; });
    return total;
}

void LegSpring::ties(std::vector<Tie> &into) const
{
    for (const Leg &leg : m_legs)
        into.emplace_back(leg.foot, leg.body);
}

Vec2 LegSpring::targetOf(const State &state, const Leg &leg) const
{
    const Vec2 body = state.at(leg.body);
    switch (m_rule.aim) {
    case Aim::bone:
        return boneTarget(body, leg.angle, m_rule.leg);
    case Aim::below:
        return belowTarget(body, leg.angle, m_rule.leg, m_rule.drop);
    case Aim::swing:
        break;
    }
    return belowTarget(body, gaitAngle(leg.angle, gaitOf(state, leg)), m_rule.leg, m_rule.drop);
}

Vec2 LegSpring::target(const State &state, int number) const
{
    return targetOf(state, m_legs.at(static_cast<std::size_t>(number)));
}

Vec2 LegSpring::pull(const State &state, const Leg &leg) const
{
    return spring(state.at(leg.foot), targetOf(state, leg), m_rule.k).pull;
}

void LegSpring::add(const State &state, Points movers, double scale, Directions, Eigen::ArrayX2d &into) const
{
    forEach(state, movers, [&](const Leg &leg) { addLeg(state, leg, scale, into); });
}

void LegSpring::addPart(const State &state, Points part, double scale, Directions,
                        Eigen::ArrayX2d &into) const
{
    const auto before = [](const Leg &leg, int point) { return lastOf(leg) < point; };
    auto leg = std::lower_bound(m_byLast.begin(), m_byLast.end(), part.first, before);
    for (; leg != m_byLast.end() && lastOf(*leg) < part.end(); ++leg) {
        if (state.feels(leg->foot) || bodyFeels(state, *leg))
            addLeg(state, *leg, scale, into);
    }
}

void LegSpring::addLeg(const State &state, const Leg &leg, double scale, Eigen::ArrayX2d &into) const
{
    const Vec2 a = pull(state, leg);
    addTo(into, leg.foot, (scale * state.inverseMass[leg.foot]) * a);
    if (m_rule.reaction == Reaction::equal)
        addTo(into, leg.body, (scale * state.inverseMass[leg.body]) * sim::reaction(a));
}

bool LegSpring::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    const Slope slope = scale * slopeToPlace(m_rule.k);
    forEach(state, movers, [&](const Leg &leg) {
        if (state.feels(leg.foot))
            addSlopeBetween(into, leg.foot, leg.body, state.inverseMass[leg.foot] * slope);
        if (bodyFeels(state, leg))
            addSlopeBetween(into, leg.body, leg.foot, state.inverseMass[leg.body] * slope);
    });
    return true;
}

/// Where the clock turns a leg it lifts what the leg has stored, too: that is the clock's work.
std::optional<double> LegSpring::energy(const State &state) const
{
    double sum = 0.0;
    for (const Leg &leg : m_legs) {
        if (!state.feels(leg.foot) && !bodyFeels(state, leg))
            continue;
        const bool oneWay = state.feels(leg.foot) && state.feels(leg.body) && !bodyFeels(state, leg);
        if (oneWay)
            return {};
        sum += springEnergy(targetOf(state, leg) - state.at(leg.foot), m_rule.k);
    }
    return sum;
}

bool LegSpring::balances(const State &state) const
{
    return std::all_of(m_legs.begin(), m_legs.end(),
                       [&](const Leg &leg) { return state.feels(leg.foot) && bodyFeels(state, leg); });
}

std::vector<Live> LegSpring::explainFoot(const State &state, const Leg &leg) const
{
    std::vector<Live> live;
    if (m_rule.aim == Aim::swing)
        live.push_back({"turned", gaitAngle(leg.angle, gaitOf(state, leg))});
    const Vec2 to = targetOf(state, leg);
    const SpringPull s = spring(state.at(leg.foot), to, m_rule.k);
    live.insert(live.end(), {{"target", to}, {"d", s.d}, {"pull", state.inverseMass[leg.foot] * s.pull}});
    return live;
}

std::vector<Live> LegSpring::explain(const State &state, int mover, Directions) const
{
    std::vector<Live> ofFoot;
    Vec2 sum;
    int felt = 0;
    forEach(state, {0, state.points()}, [&](const Leg &leg) {
        if (leg.foot == mover && state.feels(mover)) {
            ofFoot = explainFoot(state, leg);
            sum = sum + std::get<Vec2>(ofFoot.back().value);
            ++felt;
        } else if (leg.body == mover && bodyFeels(state, leg)) {
            sum = sum + state.inverseMass[mover] * sim::reaction(pull(state, leg));
            ++felt;
        }
    });
    if (felt == 0)
        return {};
    if (felt == 1 && !ofFoot.empty())
        return ofFoot;
    return {{"pull", sum}};
}

void LegSpring::rests(const State &state, std::vector<RestEnd> &into) const
{
    for (const Leg &leg : m_legs)
        into.push_back({leg.foot, leg.body, targetOf(state, leg), false});
}

}
