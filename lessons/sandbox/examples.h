#pragma once

#include "lessons/api/step.h"

namespace sandbox {

/// Those that come with the program.
std::vector<lessons::Example> ownExamples();

}
