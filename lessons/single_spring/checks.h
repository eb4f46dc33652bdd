#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace single_spring {

std::vector<lessons::Try> dragTries();
std::vector<lessons::Try> fixedCentreTries();
std::vector<lessons::Try> movingBodyTries();
std::vector<lessons::Try> offsetTries();
std::vector<lessons::Try> radialTries();

}
