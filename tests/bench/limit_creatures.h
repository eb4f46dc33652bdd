#pragma once

#include "crowd_numbers.h"

#include <cstddef>

namespace bench {

/// Four creatures, one a lane: of the body and then each foot x, y (px), and their velocities (px/frame).
struct alignas(32) FourCreatures
{
    struct Point
    {
        double x[4], y[4], vx[4], vy[4];
    };
    Point points[crowd::points];
};

/// A frame of the creatures of crowd.h in their room, as one would write it by hand for AVX2: all of a creature at once,
/// each spring once for both of its ends, nothing stored in between. It has no answer to two points in one place.
void limitFrame(FourCreatures *groups, std::size_t count);

}
