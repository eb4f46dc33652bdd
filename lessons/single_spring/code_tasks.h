#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace single_spring {

std::vector<lessons::CodeTask> dragCodeTasks();
std::vector<lessons::CodeTask> fixedCentreCodeTasks();
std::vector<lessons::CodeTask> movingBodyCodeTasks();
std::vector<lessons::CodeTask> offsetCodeTasks();
std::vector<lessons::CodeTask> radialCodeTasks();

}
