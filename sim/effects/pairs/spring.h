#pragma once

#include "sim/base/vec2.h"

namespace sim {

/// The pull of a spring, with the vector from which it was computed.
struct SpringPull
{
    Vec2 d;    ///< px, from the mover to the target
    Vec2 pull; ///< mass px/frame^2
};

/// Returns the pull of a spring with the stiffness k (mass/frame^2) and rest length 0 on `mover`, towards
/// `target`: Hooke's law.
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

/// Returns the stored energy (mass px^2/frame^2) of a spring with the stiffness k that is `extension`
/// px longer than at rest (negative: shorter). The pull is its negative gradient.
constexpr double springEnergy(double extension, double k)
{
    return 0.5 * k * extension * extension;
}

}
