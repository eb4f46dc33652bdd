#pragma once

#include <Eigen/Core>

#include <functional>

namespace sim {

class OdeSystem;

/// A smooth part of the way of one island in a whole step: where things are in it, and where they go on after it, past
/// the jump that a surface makes. Numbers go in the order of its Flow: px or degrees, and that a frame. Laps of an
/// island follow each other; those of different islands may be of the same time.
struct DenseSegment
{
    const OdeSystem *system = nullptr; ///< of the island
    double start = 0.0;                ///< frames after the phase began
    double end = 0.0;                  ///< frames
    /// Places and velocities at a time from start to end.
    std::function<void(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed)> evaluate;
    Eigen::ArrayXd positionAfter; ///< after the jump at its end
    Eigen::ArrayXd velocityAfter;
};

using SegmentVisitor = std::function<void(const DenseSegment &)>;

}
