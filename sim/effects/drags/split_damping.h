#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"

namespace sim {

namespace descriptions {
extern const EffectDescription split_damping;
}

/// What is left of a velocity, and its two parts before they were damped.
struct SplitVelocity
{
    Vec2 v;
    Vec2 parallel;
    Vec2 sideways;
};

/// Splits `v` along and across the direction `out`, and lets each part keep its own share.
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

/// Drag on one point that differs along and across the line to another point.
class SplitDamping : public DescribedEffect<Drag, descriptions::split_damping>
{
public:
    /// `along` and `across`: the share that each part of the velocity keeps each frame, from 0 to 1.
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
    SplitVelocity split(const State &state, double h) const;

    int m_mover;
    int m_anchor;
    double m_along;
    double m_across;
};

}
