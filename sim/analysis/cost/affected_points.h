#pragma once

#include "sim/scene/effect.h"

namespace sim {

/// For each point 1 if `effect` computes something when it is that point's turn, else 0.
std::vector<char> affectedPoints(const Effect &effect, const State &state);

/// How many points `effect` works on: those whose turn it takes, and those that feel what it does to them at the
/// other end.
int pointsOf(const Effect &effect, const State &state, const std::vector<char> &movers,
             DirectionRule directionRule);

}
