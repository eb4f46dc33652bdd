#pragma once

#include "sim/base/vec2.h"

#include <algorithm>
#include <cmath>

namespace sim {

/// How an effect finds the direction of a distance. A method chooses one for all its effects.
enum class DirectionRule {
    regularised, ///< direction(): two points in one place part along a direction of their own
    published,   ///< publishedDirection(): as the tutorials print it, with atan2, cos and sin
};

/// Two points in one place have no direction between them. This one is theirs: it depends on the two points'
/// numbers alone, turns by the golden angle (2.39996 rad) from pair to pair so that a crowd spreads evenly, and
/// is opposite for the two ends, so that they separate.
//! [parting_direction]
inline Vec2 fallbackDirection(int from, int to)
{
    const double pair = 1.0 + std::min(from, to) + 7.0 * std::max(from, to);
    const double side = from < to ? 1.0 : -1.0;
    const double angle = 2.399963229728653 * pair;
    return {side * std::cos(angle), side * std::sin(angle)};
}
//! [parting_direction]

/// The direction of `d` as a vector of length 1, with what it was found from.
struct Direction
{
    double length = 0.0; ///< px
    Vec2 out;
};

/// Closer than this, in px, points count as in one place: the square of a smaller distance loses digits and then
/// vanishes, so its direction would not have length 1.
constexpr double coincidenceDistance = 1e-150;

/// The direction of the distance `d` from point `from` to point `to`. The first function is all of it for points that
/// are not in one place: without a branch, so that a batch of them is computed in one go.
// Shown lines are short.
// clang-format off
inline
//! [direction]
Direction direction(Vec2 d)
{
    double square = d.x * d.x + d.y * d.y;
    double length = std::sqrt(square);
    Vec2 out = d / length;
    return {length, out};
}
inline Direction direction(
    Vec2 d, int from, int to)
{
    Direction found = direction(d);
    if (found.length < coincidenceDistance)
        found.out = fallbackDirection(from, to);
    return found;
}
//! [direction]
// clang-format on

/// The direction of a distance by its angle, with that angle.
struct PublishedDirection
{
    double angle = 0.0; ///< rad, from the x axis towards the y axis
    Vec2 out;
};

using std::atan2;
using std::cos;
using std::sin;

/// The direction of `d` as the tutorials compute it. atan2(0, 0) is 0, so points in one place part along (1, 0).
/// Published: Creatures I, step 7.
// Shown lines are short.
// clang-format off
inline
//! [published_direction]
PublishedDirection
publishedDirection(Vec2 d)
{
    double angle = atan2(d.y, d.x);
    Vec2 out = {cos(angle), sin(angle)};
    return {angle, out};
}
//! [published_direction]
// clang-format on

}
