#pragma once

#include "sim/base/direction.h"
#include "sim/scene/values.h"

namespace sim {

/// Returns by how many px a stick from `a` to `b` is longer than `length`. The result is negative if it is
/// shorter.
inline double stickError(Vec2 a, Vec2 b, double length)
{
    return sim::length(a - b) - length;
}

/// The two ends of a stick after it was enforced once, with the intermediate values.
struct StickEnds
{
    Vec2 a;
    Vec2 b;
    double distance = 0.0; ///< px, before the correction
    double error = 0.0;    ///< px, positive: too long
};

/// Moves `a` and `b` to the distance `length` (px). `a` moves by `share` of the error, `b` by the rest.
/// Coincident ends separate vertically, because atan2(0, 0) is 0. The additions have the order of the
/// published code.
/// Published: Ragdolls, constraints (the function with the error shared out).
// Shown lines are short.
// clang-format off
inline
//! [published_stick]
StickEnds publishedStick(
    Vec2 a, Vec2 b,
    double length, double share)
{
    Vec2 d = a - b;
    double distance = sim::length(d);
    double angle = -atan2(d.x, d.y);
    double error = distance - length;
    double partOfA = error * share;
    double partOfB = error * (1 - share);
    a.x += partOfA * sin(angle);
    a.y -= partOfA * cos(angle);
    b.x -= partOfB * sin(angle);
    b.y += partOfB * cos(angle);
    return {a, b, distance, error};
}
//! [published_stick]
// clang-format on

/// Moves `a` and `b` like publishedStick(), but without an angle. `from_b`: length and direction of a - b.
/// Source: Jakobsen, "Advanced character physics", 2001, section 3; with the two masses' shares in place of
/// halves.
// Shown lines are short.
// clang-format off
inline
//! [stick]
StickEnds stick(
    Vec2 a, Vec2 b, Direction from_b,
    double length, double share)
{
    double distance = from_b.length;
    double error = distance - length;
    double partOfA = error * share;
    double partOfB = error * (1 - share);
    a = a - partOfA * from_b.out;
    b = b + partOfB * from_b.out;
    return {a, b, distance, error};
}
//! [stick]
// clang-format on

}
