#pragma once

#include "crowd.h"

/// The creatures of crowd.h as a physics engine gets them.
///
/// The same: bodies, masses, where they start, springs (one for both ends), gravity, damping, walls, no rotation, a frame
/// a step, nobody sleeps, creatures do not touch each other. Not the same: an engine looks for contacts between all that
/// is near each other, so each creature has a room of its own, far enough from the next one that there is nothing
/// to find; and its points are discs that meet edges by the engine's own rules.
namespace bench::crowd {

constexpr double away = 800.0; ///< px, from room to room

/// Where the room of a creature is, px from the room of crowd.h; all of them form a square, so that no coordinate gets
/// large.
sim::Vec2 roomOf(int creatures, int creature);

}
