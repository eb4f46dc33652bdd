#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace codeling {

std::vector<lessons::Try> motorTries();
std::vector<lessons::Try> orientationTries();
std::vector<lessons::Try> anticipationTries();
std::vector<lessons::Try> squashStretchTries();
std::vector<lessons::Try> volumeTries();
std::vector<lessons::Try> tentaclesTries();

}
