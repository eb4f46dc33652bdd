#pragma once

#include "lessons/api/step.h"

namespace walking_gait {

/// How far foot 0 is from the middle of its places, px.
lessons::Measure swingWidth();
/// The length of the sum of all velocities, px/frame: the momentum, with masses of 1.
lessons::Measure momentumOfAll();
/// How far the body came to the right in the last frame, px/frame.
lessons::Measure walkingSpeed();
/// How far the feet that stand slid in the last frame, px/frame on the average.
lessons::Measure slip();
/// How fast the gait clock turns, rad/frame.
lessons::Measure clockSpeed();
/// The length of the sum of all pushes between bodies, px/frame^2.
lessons::Measure sumOfPushes();

}
