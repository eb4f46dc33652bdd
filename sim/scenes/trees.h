#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/scene.h"

namespace scenes {

/// Returns a full binary tree of 2^(levels + 1) - 1 branches: each but the twigs forks into two, 30 degrees to either
/// side and `slope` times as large. The trunk is `baseLength` px long.
sim::Tree forkedTree(int levels, double slope, double baseLength);
/// Returns a trunk of 100 px with two unequal branches.
sim::Tree bush();

/// Returns the branches of `tree`, "branch0", "branch1"..., at the angles at which they grew and at (0, 0). They turn only
/// where drivers put them.
sim::Scene branchesOf(const sim::Tree &tree);
/// Returns the same with each branch at the end of its parent, and the trunk at `root` (px).
sim::Scene standingTree(const sim::Tree &tree, sim::Vec2 root, sim::TreeFormula formula);
/// Lets branches turn by themselves: each has a spin, which is 0.
void letSwing(sim::Scene &scene);

/// A tree that swings in gusts.
struct Sway
{
    double k = 0.0;     ///< stiffness of the trunk's joint, 1/frame^2
    double damp = 1.0;  ///< the share of a spin that is left after each frame
    double front = 0.0; ///< px/frame: how fast the front of a gust runs
    double wind = 0.0;  ///< strength of the wind
    double gusts = 0.0; ///< the share by which the wind swells and ebbs
};
/// Adds what makes a tree swing: a front of gusts, springs in its joints, wind, damping, and the joints themselves.
void addSway(sim::Scene &scene, const sim::TreePtr &tree, const Sway &sway);

}
