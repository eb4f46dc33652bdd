#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"
#include "sim/scene/rest_target.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription soft_sticks;
}

/// A stick that moves only one end, and only by a fraction of the error per frame. The anchor feels nothing.
struct SoftStick
{
    int anchor = 0;
    int mover = 0;
    double min = 0.0;  ///< px; at shorter lengths the hard strength applies
    double rest = 0.0; ///< px, rest length
    double max = 0.0;  ///< px; at greater lengths the hard strength applies
};

/// The fractions of an error that a step removes, from 0 to 1.
struct Strengths
{
    double soft = 0.0; ///< for lengths between min and max, where the error is measured from rest
    double hard = 0.0; ///< for all other lengths, where the error is measured from min or max
};

/// The mover of a soft stick after a correction, with the intermediate values.
struct SoftStickEnd
{
    Vec2 x;              ///< px, position of the mover
    double length = 0.0; ///< px, before the correction
    double error = 0.0;  ///< px, positive: too long
    double part = 0.0;   ///< fraction of the error that is removed
};

/// Moves the mover of a stick from `x` along `way`, which leads from `x` to the anchor. There are three
/// cases: the stick is shorter than min, longer than max, or between the two.
/// Published: Codeling, squash and stretch.
// Shown lines are short.
// clang-format off
inline
//! [soft_stick]
SoftStickEnd softStick(
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

/// Soft sticks, enforced one after the other.
class SoftSticks : public DescribedEffect<Constraint, descriptions::soft_sticks>
{
public:
    /// `perFrame`: the fractions of an error that are removed per frame, from 0 to 1.
    SoftSticks(std::vector<SoftStick> sticks, Strengths perFrame)
        : m_sticks(std::move(sticks)), m_perFrame(perFrame)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// Enforces each stick whose mover is in `points`.
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    /// Returns the values of the last stick that moved `point`.
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;
    void addRestTargets(const State &state, std::vector<RestTarget> &into) const override;

private:
    std::vector<SoftStick> m_sticks;
    Strengths m_perFrame;
};

}
