#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace two_body {

std::vector<lessons::CodeTask> mutualCodeTasks();
std::vector<lessons::CodeTask> legLineCodeTasks();

}
