#pragma once

namespace bench {

/// Creatures as arrays, in the order of crowd.h: all bodies, all first feet, ...; one entry a point.
struct CrowdArrays
{
    int creatures = 0;
    double *x = nullptr, *y = nullptr;   ///< px
    double *vx = nullptr, *vy = nullptr; ///< px/frame
    double *ax = nullptr, *ay = nullptr; ///< px/frame^2
};

/// A frame of creatures in the air: springs, kick, damping, move, each a plain loop over arrays that the compiler makes
/// vector code from. What has neither gravity nor walls costs this, where nobody ever thought of them.
void plainFrame(const CrowdArrays &crowd);

}
