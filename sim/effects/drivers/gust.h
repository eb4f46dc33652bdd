#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"

#include <cmath>
#include <numbers>

namespace sim {

namespace descriptions {
extern const EffectDescription gust;
}

/// One step of a gust: while the button is down its front runs outwards; when it is let go its end follows. A new
/// press begins a new one. `speed` in px/frame, h in frames.
// Shown lines are short.
// clang-format off
inline
//! [gust]
GustExtent advanceGust(
    GustExtent gust, bool down,
    double speed, double h)
{
    if (down && gust.tail > 0)
        gust = {}; // a new gust
    bool blows = down || gust.front > 0;
    if (blows)
        gust.front += h * speed;
    if (blows && !down)
        gust.tail += h * speed;
    return gust;
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
    double distance, GustExtent gust,
    double gusts)
{
    if (distance > gust.front)
        return 0; // it has not come yet
    if (distance < gust.tail)
        return 0; // it is past
    double behind = gust.front - distance;
    double waves = behind / 300;
    double turn = 2 * std::numbers::pi;
    return 1 + gusts * std::sin(turn * waves);
}
//! [gust_at]
// clang-format on

/// How that share changes with the distance, 1/px; at the front and at the end, where it jumps, as inside.
inline double gustDerivative(double distance, GustExtent gust, double gusts)
{
    if (distance > gust.front || distance < gust.tail)
        return 0.0;
    const double turn = 2 * std::numbers::pi / 300;
    return -gusts * turn * std::cos(turn * (gust.front - distance));
}

/// Lets a gust run outwards from the pointer.
class GustFront : public DescribedEffect<Driver, descriptions::gust>, public InputReader
{
public:
    /// `speed` in px/frame.
    explicit GustFront(double speed) : m_speed(speed) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind signal) const override { return signal == InputKind::pointer; }
    void drive(State &state, double h) const override;
    DriverTiming timing() const override { return DriverTiming::continuous; }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    double m_speed;
};

}
