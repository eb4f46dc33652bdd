#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The checks of the things to try in each step. Their texts are in the documents.
namespace two_body {

std::vector<lessons::Check> mutualChecks();
std::vector<lessons::Check> legLineChecks();

}
