#pragma once

#include "lessons/api/try.h"
#include "view.h"

#include <vector>

/// The things to try of each step; `presets` are the step's own values, `exact` is the ExactRun that it shares.
namespace accuracy {

std::vector<lessons::Try> bigStepTries(const Exact &exact);
std::vector<lessons::Try> energyTries(const Exact &exact);
std::vector<lessons::Try> halveTries(const Exact &exact, const sim::Values &presets);
std::vector<lessons::Try> adaptTries(const Exact &exact, const sim::Values &presets);
std::vector<lessons::Try> bounceTries(const Exact &exact, const sim::Values &presets);
std::vector<lessons::Try> budgetTries(const sim::Values &presets);
std::vector<lessons::Try> crowdTries();

}
