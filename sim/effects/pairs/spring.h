#pragma once

#include "sim/base/vec2.h"

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

/// What a spring has stored that is `stretch` px longer (or shorter) than at rest. Minus its gradient is the pull.
constexpr double springEnergy(double stretch, double k)
{
    return 0.5 * k * stretch * stretch;
}

}
