#pragma once

#include <Eigen/Core>

#include <functional>

namespace sim {

/// A smooth part of the way of a whole step: where things are in it, and where they go on after it, past the jump
/// that a surface makes. Numbers go in the order of Flow: px or degrees, and that a frame.
struct Lap
{
    double start = 0.0; ///< frames after the phase began
    double end = 0.0;   ///< frames
    /// Places and velocities at a time from start to end.
    std::function<void(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed)> at;
    Eigen::ArrayXd nextPlace; ///< after the jump at its end
    Eigen::ArrayXd nextSpeed;
};

using LapVisit = std::function<void(const Lap &)>;

}
