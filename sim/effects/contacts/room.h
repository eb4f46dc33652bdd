#pragma once

#include <cmath>

namespace sim {

/// Where a room ends, and how much of its speed a body keeps when it bounces there.
struct Room
{
    double left = 0.0;   ///< px
    double right = 0.0;  ///< px
    double floor = 0.0;  ///< px
    double bounce = 1.0; ///< share of the speed across the wall that is kept, turned round

    /// Whether neither side wall can ever be reached.
    bool sidesAreFar() const { return std::isinf(left) && left < 0.0 && std::isinf(right) && right > 0.0; }
};

}
