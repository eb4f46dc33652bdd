#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace multi_foot {

std::vector<lessons::Check> twoFeetChecks();
std::vector<lessons::Check> anyNumberChecks();
std::vector<lessons::Check> grownFeetChecks();

}
