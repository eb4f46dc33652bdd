#pragma once

#include "sim/base/vec2.h"

#include <algorithm>
#include <cmath>

namespace sim {

/// How an effect computes the direction from one point to another. A method chooses one rule for all its
/// effects.
enum class DirectionRule {
    regularised, ///< direction(): each pair of coincident points separates along its own direction
    published,   ///< publishedDirection(): the tutorials' formula, with atan2, cos and sin
};

/// Returns the regularised direction from point `from` to point `to` when they coincide, as a vector of
/// length 1. It depends only on the two indices. It turns by the golden angle (2.39996 rad) from pair to
/// pair, so a crowd of coincident points spreads evenly. It is opposite for the two ends, so they separate.
//! [parting_direction]
inline Vec2 fallbackDirection(int from, int to)
{
    const double pair = 1.0 + std::min(from, to) + 7.0 * std::max(from, to);
    const double side = from < to ? 1.0 : -1.0;
    const double angle = 2.399963229728653 * pair;
    return {side * std::cos(angle), side * std::sin(angle)};
}
//! [parting_direction]

/// A direction as a vector of length 1, with the distance that it was computed from.
struct Direction
{
    double length = 0.0; ///< px
    Vec2 out;
};

/// px. Points that are closer than this count as coincident: the square of a smaller distance loses digits or
/// underflows to 0, so the direction would not have length 1.
constexpr double coincidenceDistance = 1e-150;

/// Returns the length and the direction of the vector `d`. The first function is for points that do not
/// coincide: it has no branch, so the compiler can vectorise loops that call it. The second one also handles
/// coincident points; `d` leads from point `from` to point `to`.
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

/// A direction as a vector of length 1, with its angle.
struct PublishedDirection
{
    double angle = 0.0; ///< rad, from the x axis towards the y axis
    Vec2 out;
};

using std::atan2;
using std::cos;
using std::sin;

/// Returns the direction of `d` as the tutorials compute it. atan2(0, 0) is 0, so coincident points get (1,
/// 0).
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
