#pragma once

#include "tests/bench/scenes/crowd_numbers.h"

#include "sim/scene/scene.h"

/// Many creatures of the lesson gravity_walls in one room: a body and five feet each, radial springs on both
/// ends, gravity, damping, walls. They pass through each other. The limits and the peers compute the same
/// scene.
namespace bench::crowd {

/// Returns the index of foot `foot` of a creature, or of its body if `foot` is -1. All bodies come first,
/// then the first feet of all creatures, then the second feet, and so on.
constexpr int pointOf(int creatures, int creature, int foot)
{
    return (foot + 1) * creatures + creature;
}

/// Returns creatures at rest, scattered over the room.
sim::Scene inTheRoom(int creatures);
/// Returns the same scene as the sandbox builds it: each spring has its own numbers, and effects are created
/// from their descriptions.
sim::Scene builtInTheRoom(int creatures);
/// Returns the same creatures with only springs and damping: the scene does not list gravity or walls.
sim::Scene inTheAir(int creatures);

}
