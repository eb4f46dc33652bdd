#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <Eigen/Core>

#include <vector>

/// One scene per step (see lessons/README.md). A file's points and sticks replace the step's.
namespace rigid_constraint {

/// Returns a scene of points "p0", "p1"... at (240, 165): as many as a file gives, otherwise `count`. Their
/// motion is prescribed.
sim::Scene loosePoints(const sim::Values &values, int count);
/// Returns the same scene with points that move by their velocity.
sim::Scene movingPoints(const sim::Values &values, int count);
/// Places points 0, 1, 2... at `positions`, px. Surplus positions are ignored.
void placePoints(sim::Scene &scene, const std::vector<sim::Vec2> &positions);

/// Returns a stick between points a and b. Its length is the distance of their positions, and both ends share
/// its error.
sim::Stick stickBetween(const std::vector<sim::Vec2> &positions, int a, int b);

/// Adds the sticks of a file, otherwise `sticks`.
/// @throws sim::Error "stick-without-end"
void addSticks(sim::Scene &scene, const sim::Values &values, const std::vector<sim::Stick> &sticks,
               int iterations = 1);

constexpr double jointRadius = 5.0; ///< px
constexpr double headRadius = 14.0; ///< px
/// Returns half of each point's width, in px.
Eigen::ArrayXd boxHalfWidths(const sim::Scene &scene);
/// Returns half of each point's width, in px. Point 0 is the head.
Eigen::ArrayXd ragdollHalfWidths(const sim::Scene &scene);

namespace pair {
sim::Scene setUp(const sim::Values &values);
}
namespace shared_error {
sim::Scene setUp(const sim::Values &values);
}
namespace triangle {
sim::Scene setUp(const sim::Values &values);
}
namespace list {
sim::Scene setUp(const sim::Values &values);
}
namespace verlet {
sim::Scene setUp(const sim::Values &values);
}
namespace ragdoll {
sim::Scene setUp(const sim::Values &values);
}

}
