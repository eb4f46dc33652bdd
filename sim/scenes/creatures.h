#pragma once

#include "sim/scenes/links.h"
#include "sim/scenes/points.h"

namespace scenes {

/// Widths in px, as published: Creatures I, step 17. A wall stops a body at half its width.
constexpr double bodyWidth = 30.0;
constexpr double footWidth = 10.0;

/// Returns a creature: the points "foot0", "foot1"..., then "body", all at the centre of the stage, without
/// effects. The feet move before the body.
sim::Scene creature(int feet);
/// Returns the same creature with the body as a handle: the learner can drag it, but forces do not move it.
sim::Scene creatureOnHandle(int feet);

/// Returns the points "foot" and "body" at the centre of the stage. The foot moves before the body.
sim::Scene pair();
/// Returns the same pair with the body as a handle.
sim::Scene pairOnHandle();

/// Returns one point, "foot", at the centre of the stage.
sim::Scene singleFoot();

/// Returns creature(feet) with a radial spring each way between each foot and the body. `k`: stiffness
/// (mass/frame^2), `length`: rest length (px).
sim::Scene springCreature(int feet, double k, double length);
/// Returns creature(feet) with a spring of rest length 0 each way between each foot and the body, so all
/// forces are linear. `k`: stiffness (mass/frame^2).
sim::Scene linearCreature(int feet, double k);

/// Returns several creatures: "creature0.foot0", "creature0.foot1"..., "creature0.body", "creature1.foot0"...
/// The creatures move one after the other, each the feet before the body.
sim::Scene crowd(int creatures, int feet);
/// Returns the same creatures with the points in another order: all bodies, then all first feet, all second
/// feet and so on. So the same parts of all creatures are neighbours in memory. All feet move before all
/// bodies.
sim::Scene crowdByParts(int creatures, int feet);

/// px, see placeFeet().
constexpr double spareDistance = 60.0;
/// Places the feet of a creature() at `positions` (px). If there are more feet than positions, the other feet
/// are spread evenly on a circle of radius `spareDistance` around the body.
void placeFeet(sim::Scene &scene, const std::vector<sim::Vec2> &positions);

/// Returns whether the point called `name` is a creature's body.
bool isBody(const std::string &name);
/// Returns half the width of each point, in px. Points that are no bodies have the width of a foot.
Eigen::ArrayXd halfWidths(const sim::Scene &scene);

}
