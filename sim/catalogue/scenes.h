#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "sim/scenes/points.h"

#include <utility>

/// The small scenes that the hard cases are made of.
namespace sim::hard {

Values valuesOf(std::initializer_list<std::pair<const char *, double>> numbers);

/// The middle of the stage, px.
constexpr Vec2 middle = scenes::centre;

/// One foot on a spring to the middle, 100 px away from it. Values: k, damp.
Scene footOnSpring(const Values &values);
/// A foot and a body at rest, each on a spring of length `radius` to the other, as published. Values: k, damp, radius.
Scene runawayPair(const Values &values);
/// A body with `feet` feet on springs of length `radius`, the feet `out` px from it and closer together on its right.
/// Values: k, damp, radius, feet, out.
Scene creature(const Values &values);
/// The same with all its points on one line, 30 px from each other. Values: k, damp, radius, feet.
Scene creatureOnLine(const Values &values);
/// The same in a room, with gravity. Values: those of creature(), and gravity, left, right, floor, bounce.
Scene creatureInRoom(const Values &values);
/// Two bodies on a spring without length, the one `ratio` times as heavy as the other. Values: k, damp, ratio.
Scene unequalPair(const Values &values);
/// A body that walks on two feet. Values: k, damp, gravity, speed (of the gait, rad/frame).
Scene walker(const Values &values);
/// A lead that its motor drives to the target, with a tail `behind` px behind it. Values: keep, target_x, target_y,
/// behind; soft: 1 for a tail on a soft stick, 0 for a rigid one.
Scene swimmer(const Values &values);

/// Three points and three sticks of lengths 1, 1 and 10, which no triangle has. Values: damp.
Scene contradiction(const Values &values);
/// A chain of `links` sticks between two points that stand fast, 440 px apart; its sticks are `stretched` times as
/// short as they would have to be. Values: links, stretched, damp, gravity, passes.
Scene stretchedChain(const Values &values);
/// Two points in one place on a stick of length 0, on which a heavy body hangs. Values: damp, gravity.
Scene noLengthStick(const Values &values);
/// A stick that is 50 px too short between two points that stand fast, and a body that hangs on one of them.
/// Values: damp, gravity.
Scene fixedStick(const Values &values);

/// A tree that turns to the wind. Values: levels, slope, base_length, ease, formula (0: corrected, 1: published), by
/// (0: ease, 1: distance, 2: thickness), wind, turned (degrees, by which the trunk starts off its rest).
Scene windyTree(const Values &values);
/// A tree that turns to the pointer. Values: levels, slope, base_length.
Scene turningTree(const Values &values);
/// A tree with springs in its joints, bent by `bent` degrees. Values: levels, slope, base_length, k, damp, wind, bent.
Scene springyTree(const Values &values);
/// A tree that forks as long as its branches are larger than `min_scale`. Values: slope, min_scale.
/// @throws Error "tree-too-big" (most, slope, min_scale)
Scene grownTree(const Values &values);

}
