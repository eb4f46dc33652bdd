#pragma once

#include "sim/effects/effect_description.h"

#include <cmath>

namespace sim {

namespace described {
extern const Description breeze;
}

/// A wind that blows sideways, and swells and ebbs.
struct Air
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
    const Air &air)
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
class Breeze : public Described<Force, described::breeze>
{
public:
    /// `width`: of each point in px, one row a point; `clock`: the gait clock that the gusts go by.
    Breeze(Air air, Eigen::ArrayXd width, int clock) : m_air(air), m_width(std::move(width)), m_clock(clock)
    {
    }

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return m_air.gusts == 0.0 ? Sees::tied : Sees::scene; }
    bool idle() const override { return m_air.wind == 0.0; }
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;
    bool takeInto(Taken &into) const override;

    const Air &air() const { return m_air; }

private:
    BreezePull pullOn(const State &state, int point) const
    {
        return breeze(state.at(point), m_width[point], state.gait[m_clock], m_air);
    }

    Air m_air;
    Eigen::ArrayXd m_width;
    int m_clock;
};

}
