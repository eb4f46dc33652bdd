#pragma once

#include "sim/base/vec2.h"

namespace sim {

/// Returns the velocity after a bounce off a plane: the part of `v` that goes into it is turned round, and `bounce` of it
/// is kept. `n`: the plane's normal, of length 1. px/frame.
/// walls() and ground() keep the published form of this for level and upright planes: its zeros have other signs.
/// Source: Moore and Wilhelms, "Collision detection and response for computer animation", 1988.
// Shown lines are short.
// clang-format off
constexpr
//! [reflection]
Vec2 reflected(
    Vec2 v, Vec2 n, double bounce)
{
    double into = dot(v, n);
    return v - (1 + bounce) * into * n;
}
//! [reflection]
// clang-format on

}
