#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace two_body {

std::vector<lessons::Try> mutualTries();
std::vector<lessons::Try> legLineTries();

}
