#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace gravity_walls {

std::vector<lessons::Check> wallsChecks();
std::vector<lessons::Check> gravityChecks();

}
