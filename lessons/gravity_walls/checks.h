#pragma once

#include "lessons/api/step.h"

#include <vector>

namespace gravity_walls {

std::vector<lessons::Try> wallsTries();
std::vector<lessons::Try> gravityTries();

}
