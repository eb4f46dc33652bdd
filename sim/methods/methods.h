#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// Every method there is, in the order in which to offer them.
std::vector<MethodPtr> allMethods();

/// The method called `id`, or null.
MethodPtr findMethod(const std::string &id);

/// px a step: what an adaptive method gets where nobody says another tolerance. Far below what is seen, and cheap.
constexpr double defaultTolerance = 1e-3;

/// `own` where it goes with `method`; else what `method` gets where nobody says: h = 1, or defaultTolerance.
StepSize stepFor(const Method &method, StepSize own);

}
