#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace swaying_tree {

std::vector<lessons::Try> trunkTries();
std::vector<lessons::Try> branchesTries();
std::vector<lessons::Try> randomnessTries();
std::vector<lessons::Try> towardsPointerTries();
std::vector<lessons::Try> windTries();
std::vector<lessons::Try> restTries();
std::vector<lessons::Try> distanceTries();
std::vector<lessons::Try> thicknessTries();
std::vector<lessons::Try> turbulenceTries();
std::vector<lessons::Try> realSwayTries();

}
