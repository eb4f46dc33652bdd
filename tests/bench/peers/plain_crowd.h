#pragma once

namespace bench {

/// Creatures as arrays in the order of crowd.h: all bodies, all first feet, and so on, with one entry per
/// point.
struct CrowdArrays
{
    int creatures = 0;
    double *x = nullptr, *y = nullptr;   ///< px
    double *vx = nullptr, *vy = nullptr; ///< px/frame
    double *ax = nullptr, *ay = nullptr; ///< px/frame^2
};

/// Computes a frame of creatures in the air: springs, kick, damping and move, each a plain loop that the
/// compiler can vectorise. This is the cost of a scene without gravity and walls in a program that does not
/// have them at all.
void plainFrame(const CrowdArrays &crowd);

}
