#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"
#include "sim/scene/rest_target.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription soft_sticks;
}

/// A stick that pulls one end only, and gives way: `mover` comes nearer to its place each frame, `anchor` feels
/// nothing of it.
struct SoftStick
{
    int anchor = 0;
    int mover = 0;
    double min = 0.0;  ///< px; nearer than this it pulls hard
    double rest = 0.0; ///< px
    double max = 0.0;  ///< px; farther than this it pulls hard
};

/// What part of an error goes in a step.
struct Strengths
{
    double soft = 0.0; ///< between min and max, to rest
    double hard = 0.0; ///< outside, to min or max
};

/// Where a soft stick puts its mover, and what that was found from.
struct SoftEnd
{
    Vec2 x;
    double length = 0.0; ///< px, before
    double error = 0.0;  ///< px
    double part = 0.0;   ///< of the error, what goes
};

/// Three cases: pressed too far, pulled too far, and neither. `way` leads from `x` to the anchor.
/// Published: Codeling, squash and stretch.
// Shown lines are short.
// clang-format off
inline
//! [soft_stick]
SoftEnd softStick(
    Vec2 x, Direction way,
    const SoftStick &stick,
    Strengths strength)
{
    double length = way.length;
    double error = length - stick.rest;
    double part = strength.soft;
    if (length < stick.min) {
        error = length - stick.min;
        part = strength.hard;
    } else if (length > stick.max) {
        error = length - stick.max;
        part = strength.hard;
    }
    x = x + error * part * way.out;
    return {x, length, error, part};
}
//! [soft_stick]
// clang-format on

/// Soft sticks with one movable end, one after the other.
class SoftSticks : public DescribedEffect<Constraint, descriptions::soft_sticks>
{
public:
    /// `perFrame`: what part of an error goes in a frame, 0 to 1 each.
    SoftSticks(std::vector<SoftStick> sticks, Strengths perFrame)
        : m_sticks(std::move(sticks)), m_perFrame(perFrame)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// A stick has its turn with its mover.
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    /// The last stick that moved `point`.
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;
    void addRestTargets(const State &state, std::vector<RestTarget> &into) const override;

private:
    std::vector<SoftStick> m_sticks;
    Strengths m_perFrame;
};

}
