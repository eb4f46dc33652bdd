#pragma once

#include "crowd_numbers.h"

#include "sim/scene/scene.h"

/// Many creatures of the lesson gravity_walls in one room: a body and five feet each, radial springs both ways,
/// gravity, damping, walls. They pass through each other. What the limits and the peers compute, too.
namespace bench::crowd {

/// Which point is foot `foot` of a creature, or its body where `foot` is -1. All bodies come first, then the first
/// foot of all creatures, then the second foot of all...
constexpr int pointOf(int creatures, int creature, int foot)
{
    return (foot + 1) * creatures + creature;
}

/// Scattered over the room, at rest.
sim::Scene inTheRoom(int creatures);
/// The same scene as the sandbox builds it: each spring has its own numbers, and effects are made from their
/// descriptions.
sim::Scene builtInTheRoom(int creatures);
/// The same creatures with springs and damping alone: neither gravity nor walls are listed.
sim::Scene inTheAir(int creatures);

}
