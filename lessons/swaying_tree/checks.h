#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace swaying_tree {

std::vector<lessons::Check> trunkChecks();
std::vector<lessons::Check> branchesChecks();
std::vector<lessons::Check> randomnessChecks();
std::vector<lessons::Check> towardsPointerChecks();
std::vector<lessons::Check> windChecks();
std::vector<lessons::Check> restChecks();
std::vector<lessons::Check> distanceChecks();
std::vector<lessons::Check> thicknessChecks();
std::vector<lessons::Check> turbulenceChecks();
std::vector<lessons::Check> realSwayChecks();

}
