#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace walking_gait {

std::vector<lessons::Try> bonesTries();
std::vector<lessons::Try> legsTries();
std::vector<lessons::Try> feetBelowTries();
std::vector<lessons::Try> curvedLegsTries();
std::vector<lessons::Try> swingTries();
std::vector<lessons::Try> bodyPulledTries();
std::vector<lessons::Try> groundTries();
std::vector<lessons::Try> moreFeetTries();
std::vector<lessons::Try> steeringTries();
std::vector<lessons::Try> wallsTries();
std::vector<lessons::Try> companyTries();

}
