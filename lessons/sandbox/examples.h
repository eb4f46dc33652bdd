#pragma once

#include "lessons/api/step.h"

namespace sandbox {

/// The experiments that are installed with the program.
std::vector<lessons::Example> ownExamples();

}
