#pragma once

#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription return_to_rest;
}

/// Returns the angle (degrees) of a branch after it turned back towards its rest angle for `h` frames, in one
/// explicit Euler step of `angle' = (rest - angle) / ease`. A branch within 1 degree of `rest` does not turn.
/// Published: swaying tree, returnToRest().
// Shown lines are short.
// clang-format off
inline
//! [return_to_rest]
double returnToRest(
    double angle, double rest,
    double ease, double h)
{
    double way = rest - angle;
    // within 1 degree it stays
    if (std::abs(way) > 1)
        angle += h * way / ease;
    return angle;
}
//! [return_to_rest]
// clang-format on

/// Turns every branch back towards its rest angle.
class ReturnToRest : public DescribedEffect<Driver, descriptions::return_to_rest>
{
public:
    /// `ease`: frames, the time constant.
    ReturnToRest(TreePtr tree, double ease) : m_tree(std::move(tree)), m_ease(ease) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    bool isIdle() const override { return std::isinf(m_ease); }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    TreePtr m_tree;
    double m_ease;
};

}
