#pragma once

#include <cmath>

namespace sim {

/// Two side walls and a floor.
struct Room
{
    double left = 0.0;   ///< px, x of the left wall
    double right = 0.0;  ///< px, x of the right wall
    double floor = 0.0;  ///< px, y of the floor
    double bounce = 1.0; ///< restitution: fraction of the normal velocity that remains, reversed

    /// Returns whether both side walls are infinitely far away.
    bool sidesAreFar() const { return std::isinf(left) && left < 0.0 && std::isinf(right) && right > 0.0; }
};

}
