#pragma once

#include "tests/bench/scenes/crowd_numbers.h"

#include <cstddef>

namespace bench {

/// Four creatures, one per lane: x and y (px) and velocities (px/frame) of the body, then of each foot.
struct alignas(32) FourCreatures
{
    struct Point
    {
        double x[4], y[4], vx[4], vy[4];
    };
    Point points[crowd::points];
};

/// Computes a frame of the creatures of crowd.h in their room, as hand-written code for AVX2: one creature at
/// a time, each spring once for both of its ends, without intermediate storage. It does not handle two points
/// at the same position.
void limitFrame(FourCreatures *groups, std::size_t count);

}
