#pragma once

#include "sim/catalogue/hard_case.h"

namespace sim {

/// All hard cases, in the order in which they are told.
std::vector<HardCase> hardCases();

/// The case called `id`, if there is one.
std::optional<HardCase> findHardCase(const std::string &id);

}
