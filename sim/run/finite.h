#pragma once

#include "sim/scene/effect.h"
#include "sim/simd/thread_pool.h"

namespace sim {

/// Returns whether all positions, velocities, angles, spins and accelerations of `points` are finite.
bool areFinite(const State &state, PointRange points);

/// Returns whether `firstNonFinitePoint(state)` is -1. Uses the threads of `pool` if there are many points.
bool isFinite(const State &state, ThreadPool &pool);

/// Returns the first point with a position, velocity, angle, spin or acceleration that is not finite, or -1.
/// If only a gait clock is not finite, returns the number of points.
int firstNonFinitePoint(const State &state);

}
