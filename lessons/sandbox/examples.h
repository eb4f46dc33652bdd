#pragma once

#include "lessons/api/step.h"

namespace sandbox {

/// The ten that come with the program.
std::vector<lessons::Example> ownExamples();

}
