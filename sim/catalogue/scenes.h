#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "sim/scenes/points.h"

#include <utility>

/// The scenes of the hard cases. Their stiffnesses `k` are in mass/frame^2, `damp` is a damping factor per
/// frame, and lengths are in px.
namespace sim::hard {

/// Returns the parameters with these ids and values.
Values valuesOf(std::initializer_list<std::pair<const char *, double>> numbers);

/// px, centre of the stage.
constexpr Vec2 middle = scenes::centre;

/// Returns a foot on a spring to the centre, 100 px away from it. Values: k, damp.
Scene footOnSpring(const Values &values);
/// Returns a foot and a body at rest, each on a spring of length `radius` to the other, as published.
/// Values: k, damp, radius.
Scene runawayPair(const Values &values);
/// Returns a body with `feet` feet on springs of length `radius`. The feet are `out` px from the body, and
/// closer together on its right. Values: k, damp, radius, feet, out.
Scene creature(const Values &values);
/// Returns such a creature with all points on one line, 30 px from each other. Values: k, damp, radius, feet.
Scene creatureOnLine(const Values &values);
/// Returns a creature() in a room with gravity. Values: those of creature(), gravity, left, right, floor,
/// bounce.
Scene creatureInRoom(const Values &values);
/// Returns two bodies on a spring of rest length 0. One is `ratio` times as heavy as the other.
/// Values: k, damp, ratio.
Scene unequalPair(const Values &values);
/// Returns a body that walks on two feet. Values: k, damp, gravity, speed (of the gait clock, rad/frame).
Scene walker(const Values &values);
/// Returns a swimmer: a motor drives the lead to the target, and a tail follows `behind` px behind the lead.
/// Values: keep (damping factor of the lead), target_x, target_y, behind, soft (1: soft stick, 0: rigid
/// stick).
Scene swimmer(const Values &values);

/// Returns three points and sticks of lengths 1, 1 and 10, which cannot form a triangle. Values: damp.
Scene contradiction(const Values &values);
/// Returns a chain of `links` sticks between two handles that are 440 px apart. The chain is too short for
/// this distance by the factor `stretched`. Values: links, stretched, damp, gravity, passes (iterations over
/// the sticks).
Scene stretchedChain(const Values &values);
/// Returns two coincident points on a stick of length 0, and a body that hangs on them. Values: damp,
/// gravity.
Scene noLengthStick(const Values &values);
/// Returns a stick that is 50 px too short between two handles, and a body that hangs on one of them.
/// Values: damp, gravity.
Scene fixedStick(const Values &values);

/// Where the trunks of these trees begin, px.
inline constexpr Vec2 treeRoot = {275.0, 400.0};
/// Returns a tree that turns with the wind. Values: levels, slope, base_length, ease, formula (0: corrected,
/// 1: published), by (0: ease, 1: distance, 2: thickness), wind, turned (degrees, initial bend of the trunk).
Scene windyTree(const Values &values);
/// Returns a tree that turns to the pointer. Values: levels, slope, base_length.
Scene turningTree(const Values &values);
/// Returns a tree with torsion springs in its joints, bent by `bent` degrees.
/// Values: levels, slope, base_length, k, damp, wind, bent.
Scene springyTree(const Values &values);
/// Returns a tree that forks as long as its branches are larger than `min_scale`. Values: slope, min_scale.
/// @throws Error "tree-too-big" (most, slope, min_scale)
Scene grownTree(const Values &values);

}
