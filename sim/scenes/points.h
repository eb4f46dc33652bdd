#pragma once

#include "sim/scene/scene.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Scenes that lessons, hard cases, tests and benchmarks share. Positions are in px, times in frames. All points have
/// mass 1 and are at rest, unless a function says otherwise.
namespace scenes {

/// The middle of the stage, px.
constexpr sim::Vec2 centre = {270.0, 200.0};

/// Adds an effect to those that act in `scene`, after the ones added before.
template <class Effect, class... Arguments>
void add(sim::Scene &scene, Arguments &&...arguments)
{
    scene.effects.push_back(std::make_shared<const Effect>(std::forward<Arguments>(arguments)...));
}

/// Returns one point called `name` at `x` (px) with the velocity `v` (px/frame).
sim::Scene onePoint(const std::string &name, sim::Vec2 x, sim::Vec2 v = {});

/// Returns the points "p0", "p1"... at `places` (px), which move together.
sim::Scene pointsAt(const std::vector<sim::Vec2> &places);

/// Returns a point "foot" at `x` (px) on a spring of stiffness `k` (1/frame^2) and length 0 to the place `anchor` (px).
/// Its effects: the spring, and damping that leaves the share `damp` of the velocity after each frame.
sim::Scene oscillator(sim::Vec2 x, sim::Vec2 anchor, double k, double damp);

}
