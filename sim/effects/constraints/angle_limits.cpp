#include "sim/effects/constraints/angle_limits.h"

namespace sim {

namespace {

/// Returns the highest point index of `limit`.
int highestPoint(const AngleLimit &limit)
{
    return std::max({limit.a, limit.joint, limit.b});
}

JointEnds endsOf(const AngleLimit &limit, const State &state)
{
    return bendBack(state.positionOf(limit.a), state.positionOf(limit.joint), state.positionOf(limit.b),
                    limit.least, limit.most);
}

/// Moves the dynamic points of `limit` to `ends` if the limit was exceeded.
void moveEnds(State &state, const AngleLimit &limit, const JointEnds &ends)
{
    if (ends.past == 0.0)
        return;
    const auto moveTo = [&](int point, Vec2 x) {
        if (state.isDynamic(point))
            state.place(point, x);
    };
    moveTo(limit.a, ends.a);
    moveTo(limit.joint, ends.joint);
    moveTo(limit.b, ends.b);
}

}

std::vector<Region> AngleLimits::regions(DirectionRule) const
{
    const std::string file = "sim/effects/constraints/angle_limits.h";
    return {{file, "angle_limit"}, {file, "past_limit"}, {file, "angle_between"}, {file, "turned"}};
}

int AngleLimits::count(const State &, PointRange points) const
{
    return static_cast<int>(std::count_if(m_limits.begin(), m_limits.end(), [&](const AngleLimit &limit) {
        return points.contains(highestPoint(limit));
    }));
}

void AngleLimits::addCouplings(std::vector<Coupling> &into) const
{
    for (const AngleLimit &limit : m_limits)
        into.insert(into.end(), {{limit.a, limit.joint}, {limit.joint, limit.b}});
}

void AngleLimits::enforce(State &state, PointRange points, DirectionRule, double) const
{
    for (const AngleLimit &limit : m_limits) {
        if (points.contains(highestPoint(limit)))
            moveEnds(state, limit, endsOf(limit, state));
    }
}

std::vector<LiveValue> AngleLimits::explain(const State &before, const State &, int point) const
{
    State state = before;
    std::vector<LiveValue> values;
    for (const AngleLimit &limit : m_limits) {
        const JointEnds ends = endsOf(limit, state);
        moveEnds(state, limit, ends);
        if (limit.joint == point)
            values = {{"angle", ends.angle}, {"past", ends.past}};
    }
    return values;
}

namespace descriptions {
constinit const EffectDescription angle_limits = {
    "angle_limits", SIM_TEXT("joint limits"), EffectKind::stick,
    SIM_TEXT("Keep joints from bending too far: a knee does not bend forwards.")};
}

}
