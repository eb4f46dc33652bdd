#pragma once

#include "lessons/api/try.h"
#include "view.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents. `defaultValues` are the step's values, `exact` is the reference run that
/// the step shares.
namespace accuracy {

std::vector<lessons::Check> bigStepChecks(const Exact &exact);
std::vector<lessons::Check> energyChecks(const Exact &exact);
std::vector<lessons::Check> halveChecks(const Exact &exact, const sim::Values &defaultValues);
std::vector<lessons::Check> adaptChecks(const Exact &exact, const sim::Values &defaultValues);
std::vector<lessons::Check> bounceChecks(const Exact &exact, const sim::Values &defaultValues);
std::vector<lessons::Check> budgetChecks(const sim::Values &defaultValues);
std::vector<lessons::Check> crowdChecks();

}
