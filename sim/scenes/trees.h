#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/scene.h"

namespace scenes {

/// Returns a full binary tree of 2^(levels + 1) - 1 branches. Each branch except the twigs forks into two, 30
/// degrees to either side and `slope` times as large. The trunk is `baseLength` px long.
sim::Tree forkedTree(int levels, double slope, double baseLength);
/// Returns a trunk of 100 px with two unequal branches.
sim::Tree bush();

/// Returns the branches of `tree`, "branch0", "branch1"..., at their rest angles and all at (0, 0). Their
/// motion is prescribed by drivers.
sim::Scene branchesOf(const sim::Tree &tree);
/// Returns the same branches, each at the end of its parent, with the trunk at `root` (px).
sim::Scene standingTree(const sim::Tree &tree, sim::Vec2 root, sim::TreeFormula formula);
/// Gives all branches a spin, which is 0, and lets them turn by it.
void enableSpins(sim::Scene &scene);

/// Parameters of a tree that swings in gusts.
struct Sway
{
    double k = 0.0;     ///< 1/frame^2, torsional stiffness per inertia, see branchStiffness()
    double damp = 1.0;  ///< damping factor of the spins per frame
    double front = 0.0; ///< px/frame, speed of the front of a gust
    double wind = 0.0;  ///< strength of the wind, see windPush()
    double gusts = 0.0; ///< amplitude of the gusts, see gustAt()
};
/// Adds the effects of a swinging tree: gust front, torsion springs, wind, damping and joints, in this order.
void addSway(sim::Scene &scene, const sim::TreePtr &tree, const Sway &sway);

}
