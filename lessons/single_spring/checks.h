#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace single_spring {

std::vector<lessons::Check> dragChecks();
std::vector<lessons::Check> fixedCentreChecks();
std::vector<lessons::Check> movingBodyChecks();
std::vector<lessons::Check> offsetChecks();
std::vector<lessons::Check> radialChecks();

}
