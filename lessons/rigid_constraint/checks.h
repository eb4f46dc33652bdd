#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace rigid_constraint {

std::vector<lessons::Check> pairChecks();
std::vector<lessons::Check> sharedErrorChecks();
std::vector<lessons::Check> triangleChecks();
std::vector<lessons::Check> listChecks();
std::vector<lessons::Check> verletChecks();
std::vector<lessons::Check> ragdollChecks();

}
