#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"

#include <algorithm>

namespace sim {

namespace descriptions {
extern const EffectDescription steering;
}

/// How keys and pointer set the speed of a gait clock.
struct SteeringLimits
{
    double top = 0.15;     ///< rad/frame, maximum speed in both directions
    double change = 0.004; ///< rad/frame^2, acceleration while a key is down
    double reach = 200.0;  ///< px, horizontal distance of the pointer that gives the maximum speed
};

using std::clamp;

/// Returns the speed (rad/frame) after the arrow keys were down for `h` frames. The right key increases it,
/// the left key decreases it.
// Shown lines are short.
// clang-format off
inline
//! [steer_by_keys]
double steerByKeys(
    double speed, const Keys &keys,
    const SteeringLimits &limits, double h)
{
    if (keys.right)
        speed += h * limits.change;
    if (keys.left)
        speed -= h * limits.change;
    double top = limits.top;
    return clamp(speed, -top, top);
}
//! [steer_by_keys]
// clang-format on

/// Returns the speed (rad/frame) for a pointer that is `way` px to the right of the body.
// Shown lines are short.
// clang-format off
inline
//! [steer_by_pointer]
double steerByPointer(
    double way, const SteeringLimits &limits)
{
    double top = limits.top;
    double speed = top * way / limits.reach;
    return clamp(speed, -top, top);
}
//! [steer_by_pointer]
// clang-format on

/// Sets the speed of a gait clock: by the pointer while its button is down, else by the keys that are down.
/// Otherwise the clock keeps its speed.
class Steering : public DescribedEffect<Driver, descriptions::steering>, public InputReader
{
public:
    /// `clock`: the index of the gait clock. `body`: the point from which the pointer's distance is measured.
    Steering(int clock, int body, SteeringLimits limits) : m_clock(clock), m_body(body), m_limits(limits) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &, PointRange points) const override { return points.contains(m_body) ? 1 : 0; }
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override
    {
        return kind == InputKind::pointer || kind == InputKind::keys;
    }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    int m_clock;
    int m_body;
    SteeringLimits m_limits;
};

}
