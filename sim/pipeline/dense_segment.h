#pragma once

#include <Eigen/Core>

#include <functional>

namespace sim {

class OdeSystem;

/// A smooth part of the trajectory of one island within a frame (dense output). A contact event may end it
/// with a jump. Arrays are in the order of its OdeSystem, in px or degrees, and per frame for velocities. The
/// segments of one island follow each other in time; the segments of different islands may overlap.
struct DenseSegment
{
    const OdeSystem *system = nullptr; ///< of the island
    double start = 0.0;                ///< frames after the start of the phase
    double end = 0.0;                  ///< frames
    /// Computes positions and velocities at a time from `start` to `end`.
    std::function<void(double time, Eigen::ArrayXd &position, Eigen::ArrayXd &velocity)> evaluate;
    Eigen::ArrayXd positionAfter; ///< after the jump at `end`
    Eigen::ArrayXd velocityAfter; ///< after the jump at `end`
};

using SegmentVisitor = std::function<void(const DenseSegment &)>;

}
