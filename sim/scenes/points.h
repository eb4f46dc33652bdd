#pragma once

#include "sim/scene/scene.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Scenes that lessons, hard cases, tests and benchmarks share. Positions are in px, times in frames. Points
/// have mass 1 and are at rest unless stated otherwise.
namespace scenes {

/// px, centre of the stage.
constexpr sim::Vec2 centre = {270.0, 200.0};

/// Adds an effect to `scene`, after all effects that it already has.
template <class Effect, class... Arguments>
void add(sim::Scene &scene, Arguments &&...arguments)
{
    scene.effects.push_back(std::make_shared<const Effect>(std::forward<Arguments>(arguments)...));
}

/// Returns one point called `name` at `x` (px) with the velocity `v` (px/frame).
sim::Scene onePoint(const std::string &name, sim::Vec2 x, sim::Vec2 v = {});

/// Returns the points "p0", "p1"... at `positions` (px), in one group: all of them move at the same time.
sim::Scene pointsAt(const std::vector<sim::Vec2> &positions);

/// Returns a point "foot" at `x` (px) that a spring pulls to `anchor` (px). The spring has stiffness `k`
/// (mass/frame^2) and rest length 0. The second effect is damping with the factor `damp` per frame.
sim::Scene oscillator(sim::Vec2 x, sim::Vec2 anchor, double k, double damp);

}
