#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace rigid_constraint {

std::vector<lessons::CodeTask> pairCodeTasks();
std::vector<lessons::CodeTask> sharedErrorCodeTasks();
std::vector<lessons::CodeTask> listCodeTasks();
std::vector<lessons::CodeTask> verletCodeTasks();

}
