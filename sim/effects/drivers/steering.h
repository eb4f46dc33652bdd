#pragma once

#include "sim/effects/effect_description.h"
#include "sim/scene/input_reader.h"

#include <algorithm>

namespace sim {

namespace described {
extern const Description steering;
}

/// How keys and pointer set the speed of a gait clock.
struct Reins
{
    double top = 0.15;     ///< rad/frame, the fastest either way
    double change = 0.004; ///< rad/frame^2, what a key that is down adds each frame
    double reach = 200.0;  ///< px, how far off the pointer asks for the fastest
};

using std::clamp;

/// A speed (rad/frame) after the arrow keys were down for `h` frames: right adds, left takes away.
// Shown lines are short.
// clang-format off
inline
//! [steer_by_keys]
double steerByKeys(
    double speed, const Keys &keys,
    const Reins &reins, double h)
{
    if (keys.right)
        speed += h * reins.change;
    if (keys.left)
        speed -= h * reins.change;
    double top = reins.top;
    return clamp(speed, -top, top);
}
//! [steer_by_keys]
// clang-format on

/// The speed (rad/frame) that a pointer `way` px to the right of the body asks for.
// Shown lines are short.
// clang-format off
inline
//! [steer_by_pointer]
double steerByPointer(
    double way, const Reins &reins)
{
    double top = reins.top;
    double speed = top * way / reins.reach;
    return clamp(speed, -top, top);
}
//! [steer_by_pointer]
// clang-format on

/// Sets the speed of a gait clock: by the pointer while its button is down, else by the keys that are down. With
/// neither the clock keeps the speed that it has.
class Steering : public Described<Driver, described::steering>, public InputReader
{
public:
    /// The pointer's way is measured from point `body`.
    Steering(int clock, int body, Reins reins) : m_clock(clock), m_body(body), m_reins(reins) {}

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &, Points points) const override { return points.contains(m_body) ? 1 : 0; }
    Sees sees() const override { return Sees::scene; }
    bool reads(Signal signal) const override { return signal == Signal::pointer || signal == Signal::keys; }
    void drive(State &state, double h) const override;
    std::vector<Live> explain(const State &before, const State &after, int point) const override;

private:
    int m_clock;
    int m_body;
    Reins m_reins;
};

}
