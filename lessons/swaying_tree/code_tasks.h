#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace swaying_tree {

std::vector<lessons::CodeTask> branchesCodeTasks();
std::vector<lessons::CodeTask> towardsPointerCodeTasks();
std::vector<lessons::CodeTask> restCodeTasks();

}
