#pragma once

#include "sim/forward.h"

#include <cstdint>
#include <functional>

namespace lessons {

/// What a run may be off, and what it may cost.
struct Budget
{
    double error = 0.0;      ///< px, the largest distance of any body from the exact run at any whole frame
    double nsPerFrame = 0.0; ///< that the program takes to compute it; infinite: it may cost anything
    std::int64_t frames = 0; ///< both over this stretch from the start on
};

/// How long `frames` frames of a script take, in ns a frame.
using TimeMeasurement = std::function<double(const sim::Script &script, std::int64_t frames)>;

/// Measures it on this machine, now: the median of repeated runs, as the study of accuracy does. Runs of more than
/// some milliseconds are measured once, roughly.
double measureTime(const sim::Script &script, std::int64_t frames);

/// Whether the run of `script` keeps `budget`. Steps of less than 1/128 frame do not.
bool staysWithin(const Budget &budget, const sim::Script &script, const TimeMeasurement &timing);

}
