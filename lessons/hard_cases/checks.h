#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace hard_cases {

std::vector<lessons::Check> limitChecks();
std::vector<lessons::Check> runawayChecks();
std::vector<lessons::Check> manyFeetChecks();
std::vector<lessons::Check> onePlaceChecks();
std::vector<lessons::Check> stiffChecks();
std::vector<lessons::Check> contradictionChecks();
std::vector<lessons::Check> longRunChecks();
std::vector<lessons::Check> tortureChecks();

}
