#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// Returns all methods, in the order in which the window lists them.
std::vector<MethodPtr> allMethods();

/// Returns the method with id `id`, or null.
MethodPtr findMethod(const std::string &id);

/// px per step, the default tolerance of adaptive methods: far below what is visible, but cheap.
constexpr double defaultTolerance = 1e-3;

/// Returns `requested` if its kind (fixed or adaptive) is that of `method`. Else returns the default: h = 1,
/// or defaultTolerance.
StepSize stepFor(const Method &method, StepSize requested);

}
