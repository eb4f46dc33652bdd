#pragma once

#include "lessons/api/step.h"

#include <vector>

/// The parameters of this lesson, and values of them that go well together.
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

/// Other trees, with those of their values that `step` has.
std::vector<lessons::Preset> galleryFor(const lessons::Step &step);

}
