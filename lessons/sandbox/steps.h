#pragma once

#include "lessons/api/step.h"

namespace sandbox {

/// Returns the only step. Its scene is built by a learner or a file.
lessons::Step buildStep();

}
