#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace codeling {

std::vector<lessons::Check> motorChecks();
std::vector<lessons::Check> orientationChecks();
std::vector<lessons::Check> anticipationChecks();
std::vector<lessons::Check> squashStretchChecks();
std::vector<lessons::Check> volumeChecks();
std::vector<lessons::Check> tentaclesChecks();

}
