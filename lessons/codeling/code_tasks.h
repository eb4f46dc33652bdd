#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace codeling {

std::vector<lessons::CodeTask> motorCodeTasks();
std::vector<lessons::CodeTask> orientationCodeTasks();
std::vector<lessons::CodeTask> anticipationCodeTasks();
std::vector<lessons::CodeTask> volumeCodeTasks();

}
