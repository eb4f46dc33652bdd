#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace hard_cases {

std::vector<lessons::Try> limitTries();
std::vector<lessons::Try> runawayTries();
std::vector<lessons::Try> manyFeetTries();
std::vector<lessons::Try> onePlaceTries();
std::vector<lessons::Try> stiffTries();
std::vector<lessons::Try> contradictionTries();
std::vector<lessons::Try> longRunTries();
std::vector<lessons::Try> tortureTries();

}
