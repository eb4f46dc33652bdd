#include "sim/effects/constraints/soft_sticks.h"

namespace sim {

namespace {

/// Returns the fraction of an error that is removed in `h` frames if the fraction `perFrame` is removed per
/// frame. The fractions that remain multiply.
//! [part_in_step]
double partIn(double h, double perFrame)
{
    double left = std::pow(1 - perFrame, h);
    return 1 - left;
}
//! [part_in_step]

Strengths strengthsIn(double h, Strengths perFrame)
{
    if (h == 1.0)
        return perFrame; // exact: 1 - (1 - perFrame) would round
    return {partIn(h, perFrame.soft), partIn(h, perFrame.hard)};
}

/// Returns the direction from the mover of `stick` to its anchor.
Direction directionToAnchor(const SoftStick &stick, const State &state)
{
    return direction(state.positionOf(stick.anchor) - state.positionOf(stick.mover), stick.mover,
                     stick.anchor);
}

}

std::vector<Region> SoftSticks::regions(DirectionRule) const
{
    return {{"sim/effects/constraints/soft_sticks.h", "soft_stick"},
            {"sim/effects/constraints/soft_sticks.cpp", "part_in_step"},
            {"sim/base/direction.h", "direction"}};
}

int SoftSticks::count(const State &state, PointRange points) const
{
    return static_cast<int>(std::count_if(m_sticks.begin(), m_sticks.end(), [&](const SoftStick &stick) {
        return points.contains(stick.mover) && state.isDynamic(stick.mover);
    }));
}

void SoftSticks::addCouplings(std::vector<Coupling> &into) const
{
    for (const SoftStick &stick : m_sticks)
        into.emplace_back(stick.mover, stick.anchor);
}

void SoftSticks::enforce(State &state, PointRange points, DirectionRule, double h) const
{
    const Strengths strength = strengthsIn(h, m_perFrame);
    for (const SoftStick &stick : m_sticks) {
        if (points.contains(stick.mover) && state.isDynamic(stick.mover))
            state.place(
                stick.mover,
                softStick(state.positionOf(stick.mover), directionToAnchor(stick, state), stick, strength).x);
    }
}

std::vector<LiveValue> SoftSticks::explain(const State &before, const State &after, int point) const
{
    if (!before.isDynamic(point))
        return {};
    const SoftStick *last = nullptr;
    for (const SoftStick &stick : m_sticks)
        last = stick.mover == point ? &stick : last;
    if (!last)
        return {};
    const SoftStickEnd end =
        softStick(before.positionOf(point), directionToAnchor(*last, before), *last, m_perFrame);
    return {{"length", end.length},
            {"error", end.error},
            {"x", after.positionOf(point), before.positionOf(point)}};
}

void SoftSticks::addRestTargets(const State &state, std::vector<RestTarget> &into) const
{
    for (const SoftStick &stick : m_sticks)
        into.push_back(restTargetAt(state, stick.mover, stick.anchor, stick.rest));
}

namespace descriptions {
constinit const EffectDescription soft_sticks = {
    "soft_sticks", SIM_TEXT("soft sticks"), EffectKind::stick,
    SIM_TEXT("Keep a point near its distance, but let it lag behind for a while.")};
}

}
