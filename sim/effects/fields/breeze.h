#pragma once

#include "sim/effects/effect_description.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription breeze;
}

/// A wind that blows sideways, and swells and ebbs.
struct BreezeStrength
{
    double wind =
        0.0; ///< px/frame^2, what it does to a body of mass 1 that is 10 px wide; below 0: to the left
    double gusts = 0.0; ///< from 0 to 1, the share by which it swells and ebbs
};

/// What the wind does to a body, with what it was found from.
struct BreezePull
{
    double swell = 0.0;
    Vec2 pull; ///< px/frame^2, for mass 1
};

using std::sin;

/// The wind on a body that is `width` px wide, where the clock of the gusts stands at `gait` (rad). A gust travels over
/// the scene: one crest follows the other in 2 pi 100 px.
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

/// Wind over the whole scene: it pushes every body, the wide ones more. What it does is its work, and stored nowhere.
class Breeze : public DescribedEffect<Force, descriptions::breeze>
{
public:
    /// `width`: of each point in px, one row a point; `clock`: the gait clock that the gusts go by.
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
