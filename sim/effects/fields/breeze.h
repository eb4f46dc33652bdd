#pragma once

#include "sim/effects/effect_description.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription breeze;
}

/// The strength of a horizontal wind.
struct BreezeStrength
{
    /// px/frame^2, mean acceleration of a body of mass 1 that is 10 px wide; positive: to the right.
    double wind = 0.0;
    double gusts = 0.0; ///< 0 to 1, amplitude of the gusts as a fraction of `wind`
};

/// The force of the wind on a body, with its intermediate values.
struct BreezePull
{
    double swell = 0.0; ///< fraction by which the wind is now stronger than its mean
    Vec2 pull;          ///< mass px/frame^2
};

using std::sin;

/// Computes the force of the wind on a body at `x` (px) that is `width` px wide. `gait`: rad, angle of the
/// clock that drives the gusts. The gusts are a sine wave that travels to the right, with a wavelength of 200
/// pi px.
// Shown lines are short.
// clang-format off
inline
//! [breeze]
BreezePull breeze(
    Vec2 x, double width, double gait,
    const BreezeStrength &air)
{
    // gusts travel to the right
    double swell =
        air.gusts * sin(gait - x.x / 100);
    double push = air.wind * (1 + swell);
    // a wide body takes more of it
    Vec2 pull = {push * width / 10, 0};
    return {swell, pull};
}
//! [breeze]
// clang-format on

/// A wind over the whole scene. Its force on a body is proportional to the width of the body. It has no
/// potential.
class Breeze : public DescribedEffect<Force, descriptions::breeze>
{
public:
    /// `width`: px, width of each point. `clock`: index of the gait clock that drives the gusts.
    Breeze(BreezeStrength air, Eigen::ArrayXd width, int clock)
        : m_strength(air), m_width(std::move(width)), m_clock(clock)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override
    {
        return m_strength.gusts == 0.0 ? Dependence::coupledPoints : Dependence::scene;
    }
    bool isIdle() const override { return m_strength.wind == 0.0; }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const BreezeStrength &air() const { return m_strength; }

private:
    BreezePull pullOn(const State &state, int point) const
    {
        return breeze(state.positionOf(point), m_width[point], state.gait[m_clock], m_strength);
    }

    BreezeStrength m_strength;
    Eigen::ArrayXd m_width;
    int m_clock;
};

}
