#pragma once

#include "sim/run/script/script.h"

#include <limits>
#include <string>

namespace support {

/// The extent, in px, and the mean velocity of a point over some frames.
struct MotionSummary
{
    double top = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();
    double left = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double meanVelocity = 0.0; ///< px/frame, positive to the right
};

/// Returns the motion of the point `body` from frame `from` to frame `to`.
MotionSummary motionOf(const sim::Script &script, const std::string &body, int from, int to);

/// Returns the momentum of points of mass 1, px/frame.
sim::Vec2 momentumOf(const sim::State &state);

}
