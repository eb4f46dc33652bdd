#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace multi_foot {

std::vector<lessons::Try> twoFeetTries();
std::vector<lessons::Try> anyNumberTries();
std::vector<lessons::Try> grownFeetTries();

}
