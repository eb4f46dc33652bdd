#pragma once

#include "sim/run/script/script.h"

#include <limits>
#include <string>

namespace support {

/// Where a point came between two frames, in px.
struct Course
{
    double top = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();
    double left = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double pace = 0.0; ///< px to the right per frame, on the average
};

/// The course of the point called `body` from frame `from` to frame `to`.
Course courseOf(const sim::Script &script, const std::string &body, int from, int to);

}
