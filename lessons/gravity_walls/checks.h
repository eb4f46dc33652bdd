#pragma once

#include "lessons/api/try.h"

#include <vector>

namespace gravity_walls {

std::vector<lessons::Try> wallsTries();
std::vector<lessons::Try> gravityTries();

}
