#pragma once

#include "sim/vec2.h"

namespace sim {

/// A spring's pull, with the distance it comes from.
struct SpringPull
{
    Vec2 d;    ///< px
    Vec2 pull; ///< px/frame^2
};

/// Hooke's law: the pull on `mover` is k times its distance to `target`. k in 1/frame^2.
/// Published: Creatures I, step 4.
// Shown lines are short.
// clang-format off
inline
//! [spring]
SpringPull spring(
    Vec2 mover, Vec2 target, double k)
{
    Vec2 d = target - mover;
    Vec2 pull = k * d;
    return {d, pull};
}
//! [spring]
// clang-format on

/// What that spring has stored, stretched by `d`: k d^2 / 2. Its gradient by the mover is minus the pull.
constexpr double springEnergy(Vec2 d, double k)
{
    return 0.5 * k * (d.x * d.x + d.y * d.y);
}

}
