#pragma once

#include "sim/effects/effect_description.h"

#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription gait_clock;
}

/// Returns the angle (rad) of a gait clock after `h` frames. `speed` in rad/frame.
/// Published: Creatures II, step 9.
// Shown lines are short.
// clang-format off
inline
//! [gait_clock]
double tick(
    double gait, double speed, double h)
{
    gait = gait + h * speed;
    return gait;
}
//! [gait_clock]
// clang-format on

/// Advances all gait clocks of the scene by their speeds (State::gaitSpeed).
class GaitClock : public DescribedEffect<Driver, descriptions::gait_clock>
{
public:
    /// `clockOf`: the index of each point's gait clock, for explain(). Empty: all points have clock 0.
    explicit GaitClock(std::vector<int> clockOf = {}) : m_clockOf(std::move(clockOf)) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    void drive(State &state, double h) const override;
    DriverTiming timing() const override { return DriverTiming::continuous; }
    bool addToDraft(BlueprintDraft &) const override { return true; } // implied by the legs
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    std::vector<int> m_clockOf;
};

}
