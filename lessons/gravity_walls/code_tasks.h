#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace gravity_walls {

std::vector<lessons::CodeTask> wallsCodeTasks();
std::vector<lessons::CodeTask> gravityCodeTasks();

}
