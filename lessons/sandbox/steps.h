#pragma once

#include "lessons/api/step.h"

namespace sandbox {

/// The one step: its scene is what a learner, or a file, builds.
lessons::Step buildStep();

}
