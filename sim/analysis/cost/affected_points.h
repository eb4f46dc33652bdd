#pragma once

#include "sim/scene/effect.h"

namespace sim {

/// Returns for each point 1 if `effect` computes anything for it in `state`, else 0.
std::vector<char> affectedPoints(const Effect &effect, const State &state);

/// Returns how many points `effect` works on in `state`. These are the points in `movers`, and the points at
/// the other ends of their couplings.
/// @param movers the result of affectedPoints()
int pointsOf(const Effect &effect, const State &state, const std::vector<char> &movers,
             DirectionRule directionRule);

}
