#pragma once

#include "sim/catalogue/hard_case.h"

namespace sim {

/// Returns all hard cases, in the order in which they are presented.
std::vector<HardCase> hardCases();

/// Returns the case called `id`; empty if there is none.
std::optional<HardCase> findHardCase(const std::string &id);

}
