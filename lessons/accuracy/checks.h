#pragma once

#include "lessons/api/try.h"
#include "view.h"

#include <vector>

/// The things to try in each step. `defaultValues` are the step's values, `exact` is the reference run that
/// the step shares.
namespace accuracy {

std::vector<lessons::Try> bigStepTries(const Exact &exact);
std::vector<lessons::Try> energyTries(const Exact &exact);
std::vector<lessons::Try> halveTries(const Exact &exact, const sim::Values &defaultValues);
std::vector<lessons::Try> adaptTries(const Exact &exact, const sim::Values &defaultValues);
std::vector<lessons::Try> bounceTries(const Exact &exact, const sim::Values &defaultValues);
std::vector<lessons::Try> budgetTries(const sim::Values &defaultValues);
std::vector<lessons::Try> crowdTries();

}
