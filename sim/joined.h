#pragma once

#include "sim/method.h"

#include <vector>

namespace sim {

/// The same step in fewer phases: neighbours that are rules for one point, on the same points, become one phase, which
/// takes each point through all of them at once. It comes to the same in every bit, and shows nothing: it is for steps
/// that nobody looks into. The others are as they were.
std::vector<Phase> joined(const std::vector<Phase> &phases);

}
