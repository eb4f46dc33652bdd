#pragma once

#include "sim/effects/constraints/sticks.h"
#include "sim/scene/scene.h"

#include <vector>

/// Chains, and other figures of sticks.
namespace scenes {

/// Returns the sticks from each point to the next one, `links` of them and each `length` px long.
std::vector<sim::Stick> chainOfSticks(int links, double length);

/// Points joined by sticks.
struct StickFigure
{
    std::vector<sim::Vec2> places = {}; ///< px
    std::vector<sim::Stick> sticks = {};
    std::vector<int> pinned = {}; ///< the points that are handles
    double gravity = 0.5;         ///< px/frame^2
    double damp = 1.0;            ///< the share of a velocity that is left after each frame
    int passes = 1;               ///< over all sticks, in each step
};
/// Returns the points "p0", "p1"... of `figure`, which fall. Its effects: gravity, damping, sticks.
sim::Scene fallingSticks(const StickFigure &figure);

}
