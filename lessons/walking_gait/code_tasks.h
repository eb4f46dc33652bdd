#pragma once

#include "lessons/api/listing.h"

#include <vector>

/// The tasks to write a part of each step's listing.
namespace walking_gait {

std::vector<lessons::CodeTask> bonesCodeTasks();
std::vector<lessons::CodeTask> swingCodeTasks();
std::vector<lessons::CodeTask> bodyPulledCodeTasks();
std::vector<lessons::CodeTask> groundCodeTasks();

}
