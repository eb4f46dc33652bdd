#pragma once

#include "sim/effects/links.h"
#include "sim/scene.h"

#include <vector>

/// Many creatures of the lesson gravity_walls in one room: a body and five feet each, radial springs both ways,
/// gravity, damping, walls. They pass through each other. What the limits and the peers compute, too.
namespace bench::crowd {

constexpr int feet = 5;
constexpr int points = feet + 1; ///< of one creature
constexpr double k = 0.2;        ///< 1/frame^2
constexpr double radius = 50.0;  ///< px, the springs' rest length
constexpr double damp = 0.85;    ///< share of a velocity that is left after a frame
constexpr double gravity = 0.5;  ///< px/frame^2
constexpr double left = 20.0, right = 520.0, floor = 380.0; ///< px, the room
constexpr double bounce = 1.0;                              ///< share of its speed that a wall leaves a point
constexpr double halfBody = 15.0, halfFoot = 5.0;           ///< px, half of their widths

/// A run starts again after so many frames: later all creatures would lie still, and nobody meets a wall.
constexpr int frames = 200;

/// Which point is foot `foot` of a creature, or its body where `foot` is -1. All bodies come first, then the first
/// foot of all creatures, then the second foot of all...
constexpr int pointOf(int creatures, int creature, int foot)
{
    return (foot + 1) * creatures + creature;
}

/// The springs, foot by foot: to each foot of all creatures from their bodies, then the other way.
std::vector<sim::Link> springs(int creatures);

/// Scattered over the room, at rest.
sim::Scene inTheRoom(int creatures);
/// The same creatures with springs and damping alone: neither gravity nor walls are listed.
sim::Scene inTheAir(int creatures);

}
