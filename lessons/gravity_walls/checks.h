#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace gravity_walls {

std::vector<lessons::Try> wallsTries();
std::vector<lessons::Try> gravityTries();

}
