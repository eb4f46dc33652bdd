#pragma once

#include "sim/scene/effect.h"
#include "sim/simd/thread_pool.h"

namespace sim {

/// Whether all numbers that `points` have in `state` are finite.
bool areFinite(const State &state, PointRange points);

/// Whether all numbers of `state` are: the same as firstNonFinitePoint() finding none. Where there are many, `crew` shares
/// them among its threads.
bool isFinite(const State &state, ThreadPool &pool);

/// Returns the first point with a position, velocity, angle, spin or acceleration that is not finite, or -1. A number
/// that belongs to no point gives the number of points.
int firstNonFinitePoint(const State &state);

}
