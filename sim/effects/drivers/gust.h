#pragma once

#include "sim/effects/effect_description.h"
#include "sim/scene/input_reader.h"

#include <cmath>
#include <numbers>

namespace sim {

namespace described {
extern const Description gust;
}

/// One step of a gust: while the button is down its front runs outwards; when it is let go its end follows. A new
/// press begins a new one. `speed` in px/frame, h in frames.
// Shown lines are short.
// clang-format off
inline
//! [gust]
Gale runOn(
    Gale gale, bool down,
    double speed, double h)
{
    if (down && gale.end > 0)
        gale = {}; // a new gust
    bool blows = down || gale.front > 0;
    if (blows)
        gale.front += h * speed;
    if (blows && !down)
        gale.end += h * speed;
    return gale;
}
//! [gust]
// clang-format on

/// How hard the wind blows `distance` px from the pointer, as a share of its strength: 0 where the front has not
/// come to or the end is past; between them it swells and ebbs every 300 px, by the share `gusts`.
// Shown lines are short.
// clang-format off
inline
//! [gust_at]
double gustAt(
    double distance, Gale gale,
    double gusts)
{
    if (distance > gale.front)
        return 0; // it has not come yet
    if (distance < gale.end)
        return 0; // it is past
    double behind = gale.front - distance;
    double waves = behind / 300;
    double turn = 2 * std::numbers::pi;
    return 1 + gusts * std::sin(turn * waves);
}
//! [gust_at]
// clang-format on

/// How that share changes with the distance, 1/px; at the front and at the end, where it jumps, as inside.
inline double gustSlope(double distance, Gale gale, double gusts)
{
    if (distance > gale.front || distance < gale.end)
        return 0.0;
    const double turn = 2 * std::numbers::pi / 300;
    return -gusts * turn * std::cos(turn * (gale.front - distance));
}

/// Lets a gust run outwards from the pointer.
class GustFront : public Described<Driver, described::gust>, public InputReader
{
public:
    /// `speed` in px/frame.
    explicit GustFront(double speed) : m_speed(speed) {}

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::scene; }
    bool reads(Signal signal) const override { return signal == Signal::pointer; }
    void drive(State &state, double h) const override;
    Pace pace() const override { return Pace::flows; }
    std::vector<Live> explain(const State &before, const State &after, int point) const override;

private:
    double m_speed;
};

}
