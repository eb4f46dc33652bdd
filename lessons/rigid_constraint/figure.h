#pragma once

#include "sim/effects/constraints/sticks.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <vector>

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

/// The sticks that act in `scene`; none if there are none.
std::vector<sim::Stick> sticksOf(const sim::Scene &scene);
/// The largest error, in px without its sign, and in % of the stick's length (where that is not 0).
double largestError(const sim::Scene &scene, const sim::State &state);
double largestStretch(const sim::Scene &scene, const sim::State &state);

/// Half of each point's width, px: the head's, then the joints'.
constexpr double jointRadius = 5.0;
constexpr double headRadius = 14.0;
Eigen::ArrayXd boxHalfWidths(const sim::Scene &scene);
Eigen::ArrayXd ragdollHalfWidths(const sim::Scene &scene);

}
