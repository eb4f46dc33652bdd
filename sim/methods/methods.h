#pragma once

#include "sim/method.h"

namespace sim {

/// Every method there is, in the order in which to offer them.
std::vector<MethodPtr> allMethods();

/// The method called `id`, or null.
MethodPtr findMethod(const std::string &id);

}
