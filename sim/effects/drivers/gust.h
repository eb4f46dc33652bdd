#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"

#include <cmath>
#include <numbers>

namespace sim {

namespace descriptions {
extern const EffectDescription gust;
}

/// Returns the extent of a gust after `h` frames. While the button is down, the front runs outwards at
/// `speed` (px/frame). After the button is released, the tail follows. A new press starts a new gust.
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

/// Returns the strength of the wind `distance` px from the pointer, as a fraction of its full strength. It is
/// 0 ahead of the front and behind the tail. Between them it is a sine wave around 1 with amplitude `gusts`
/// and wavelength 300 px.
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

/// Returns the derivative of gustAt() by the distance, in 1/px. The jumps at the front and at the tail are
/// ignored.
inline double gustDerivative(double distance, GustExtent gust, double gusts)
{
    if (distance > gust.front || distance < gust.tail)
        return 0.0;
    const double turn = 2 * std::numbers::pi / 300;
    return -gusts * turn * std::cos(turn * (gust.front - distance));
}

/// Advances the gust that runs outwards from the pointer.
class GustFront : public DescribedEffect<Driver, descriptions::gust>, public InputReader
{
public:
    /// `speed` in px/frame.
    explicit GustFront(double speed) : m_speed(speed) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override { return kind == InputKind::pointer; }
    void drive(State &state, double h) const override;
    DriverTiming timing() const override { return DriverTiming::continuous; }
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    double m_speed;
};

}
