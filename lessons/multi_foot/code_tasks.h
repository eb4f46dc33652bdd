#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace multi_foot {

std::vector<lessons::CodeTask> twoFeetCodeTasks();
std::vector<lessons::CodeTask> anyNumberCodeTasks();
std::vector<lessons::CodeTask> grownFeetCodeTasks();

}
