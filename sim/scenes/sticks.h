#pragma once

#include "sim/effects/constraints/sticks.h"
#include "sim/scene/scene.h"

#include <vector>

/// Scenes made of sticks, such as chains.
namespace scenes {

/// Returns a chain of `links` sticks from each point to the next. `length`: px, of each stick.
std::vector<sim::Stick> chainOfSticks(int links, double length);

/// Points connected by sticks.
struct StickFigure
{
    std::vector<sim::Vec2> places = {};  ///< px, position of each point
    std::vector<sim::Stick> sticks = {}; ///< in the order in which they are enforced
    std::vector<int> pinned = {};        ///< indices of the points that are handles
    double gravity = 0.5;                ///< px/frame^2
    double damp = 1.0;                   ///< damping factor per frame
    int passes = 1;                      ///< iterations over all sticks per step
};
/// Returns the points "p0", "p1"... of `figure` with the effects gravity, damping and sticks.
sim::Scene fallingSticks(const StickFigure &figure);

}
