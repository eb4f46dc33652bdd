#pragma once

#include "lessons/api/step.h"

#include <vector>

/// The parameters and presets of this lesson.
namespace swaying_tree {

lessons::Parameter formula();
lessons::Parameter baseLength();
lessons::Parameter spread();
lessons::Parameter slope();
lessons::Parameter minScale();
lessons::Parameter jitter();
lessons::Parameter ease();
lessons::Parameter windStrength();
lessons::Parameter turbulenceAngle();
lessons::Parameter gustSpeed();
lessons::Parameter gusts();

/// Returns presets of other trees, with values only for the parameters that `step` has.
std::vector<lessons::Preset> galleryFor(const lessons::Step &step);

}
