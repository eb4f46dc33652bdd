#pragma once

#include "sim/scenes/links.h"
#include "sim/scenes/points.h"

namespace scenes {

/// Widths in px, as published: Creatures I, step 17 (half of them counts at a wall).
constexpr double bodyWidth = 30.0;
constexpr double footWidth = 10.0;

/// Returns the points "foot0", "foot1"..., then "body", all in the middle of the stage. The feet move before the body.
sim::Scene creature(int feet);
/// Returns the same with a body that a hand can carry but no force moves.
sim::Scene creatureOnHandle(int feet);

/// Returns the points "foot" and "body" in the middle of the stage. The foot moves before the body.
sim::Scene pair();
/// Returns the same with a body that a hand can carry but no force moves.
sim::Scene pairOnHandle();

/// Returns one point, "foot", in the middle of the stage.
sim::Scene loneFoot();

/// Returns creature(feet) with radial springs of stiffness `k` (1/frame^2) and length `length` (px) from each foot to the
/// body and back.
sim::Scene springCreature(int feet, double k, double length);
/// Returns creature(feet) with springs of stiffness `k` (1/frame^2) and length 0 from each foot to the body and back: all
/// forces are linear.
sim::Scene linearCreature(int feet, double k);

/// Returns several creatures: "creature0.foot0", "creature0.foot1"..., "creature0.body", "creature1.foot0"... Each moves
/// its feet, then its body, before the next creature moves.
sim::Scene crowd(int creatures, int feet);
/// Returns the same creatures in another order: all bodies, then all first feet, all second feet and so on, so that equal
/// parts lie side by side. All feet move, then all bodies.
sim::Scene crowdByParts(int creatures, int feet);

/// Puts the feet of a creature() at `places` (px), and the feet beyond those evenly on a circle round the body,
/// `spareDistance` px away from it.
constexpr double spareDistance = 60.0;
void placeFeet(sim::Scene &scene, const std::vector<sim::Vec2> &places);

/// Returns whether the point called `name` is a creature's body.
bool isBody(const std::string &name);
/// Returns half of each point's width, px: a body's, or else a foot's.
Eigen::ArrayXd halfWidths(const sim::Scene &scene);

}
