#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <Eigen/Core>

#include <vector>

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new. A file's points and sticks take the place of the step's own.
namespace rigid_constraint {

/// Points "p0", "p1"... at (240, 165): as many as a file gives, or else `own`. They stay where they are put.
sim::Scene loosePoints(const sim::Values &values, int own);
/// The same with points that go on by themselves.
sim::Scene movingPoints(const sim::Values &values, int own);
/// Puts point 0, 1, 2... where `places` says, px, as far as there are such points.
void placePoints(sim::Scene &scene, const std::vector<sim::Vec2> &places);

/// A stick from place a to place b that is as long as they are apart; both ends share its error.
sim::Stick stickBetween(const std::vector<sim::Vec2> &places, int a, int b);

/// Adds the sticks of a file, or else `own`.
/// @throws sim::Error "stick-without-end"
void addSticks(sim::Scene &scene, const sim::Values &values, const std::vector<sim::Stick> &own,
               int iterations = 1);

/// Half of each point's width, px: the head's, then the joints'.
constexpr double jointRadius = 5.0;
constexpr double headRadius = 14.0;
Eigen::ArrayXd boxHalfWidths(const sim::Scene &scene);
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
