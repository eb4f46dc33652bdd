#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace walking_gait {

std::vector<lessons::Check> bonesChecks();
std::vector<lessons::Check> legsChecks();
std::vector<lessons::Check> feetBelowChecks();
std::vector<lessons::Check> curvedLegsChecks();
std::vector<lessons::Check> swingChecks();
std::vector<lessons::Check> bodyPulledChecks();
std::vector<lessons::Check> groundChecks();
std::vector<lessons::Check> moreFeetChecks();
std::vector<lessons::Check> steeringChecks();
std::vector<lessons::Check> wallsChecks();
std::vector<lessons::Check> companyChecks();

}
