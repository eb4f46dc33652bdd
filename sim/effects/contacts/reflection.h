#pragma once

#include "sim/base/vec2.h"

namespace sim {

/// Returns the velocity (px/frame) after a bounce off a plane. The normal component of `v` is reversed and
/// multiplied by `bounce`. `n`: the normal of the plane, of length 1. walls() and ground() use the published
/// form for level and upright planes instead, because its zeros have other signs.
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
