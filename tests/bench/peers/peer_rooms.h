#pragma once

#include "tests/bench/scenes/crowd.h"

/// The creatures of crowd.h, adapted to a physics engine.
///
/// The same: bodies, masses, start positions, springs (one for both ends), gravity, damping, walls, no
/// rotation, one step per frame, no sleeping, no contacts between creatures. Different: an engine looks for
/// contacts between all nearby bodies. Each creature therefore has its own room, far enough from the next one
/// that there are no contacts to find. Points are discs that touch edges by the engine's own rules.
namespace bench::crowd {

constexpr double away = 800.0; ///< px, distance between rooms

/// Returns the position of a creature's room, px from the room of crowd.h. The rooms form a square, which
/// keeps the coordinates small.
sim::Vec2 roomOf(int creatures, int creature);

}
