#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription split_damping;
}

/// A damped velocity, with its two components before damping. All in px/frame.
struct SplitVelocity
{
    Vec2 v;
    Vec2 parallel; ///< along the direction
    Vec2 sideways; ///< across the direction
};

/// Splits `v` into components along and across the direction `out`, and multiplies them by the factors
/// `along` and `across`.
/// Published: Codeling, squash and stretch.
// Shown lines are short.
// clang-format off
inline
//! [split_damping]
SplitVelocity dampSplit(
    Vec2 v, Vec2 out,
    double along, double across)
{
    double speed = v.x * out.x + v.y * out.y;
    Vec2 parallel = speed * out;
    Vec2 sideways = v - parallel;
    v = along * parallel + across * sideways;
    return {v, parallel, sideways};
}
//! [split_damping]
// clang-format on

/// A drag on one point with different damping factors along and across the line to another point.
class SplitDamping : public DescribedEffect<Drag, descriptions::split_damping>
{
public:
    /// `along` and `across`: damping factors per frame, from 0 to 1.
    SplitDamping(int mover, int anchor, double along, double across)
        : m_mover(mover), m_anchor(anchor), m_along(along), m_across(across)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override { into.emplace_back(m_mover, m_anchor); }
    void apply(State &state, PointRange points, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point,
                                   double h) const override;

private:
    /// Returns the velocity of the mover after `h` frames of damping.
    SplitVelocity split(const State &state, double h) const;

    int m_mover;
    int m_anchor;
    double m_along;
    double m_across;
};

}
