#pragma once

#include "sim/forward.h"

#include <cstdint>
#include <functional>

namespace lessons {

/// The largest error and the largest computing time that a run may have.
struct Budget
{
    double error = 0.0;      ///< px, largest distance of any point from the exact run at any whole frame
    double nsPerFrame = 0.0; ///< computing time; infinite: no limit
    std::int64_t frames = 0; ///< length of the run, from its start, for which both limits hold
};

/// Returns the time that the first `frames` frames of a script take to compute, in ns per frame.
using TimeMeasurement = std::function<double(const sim::Script &script, std::int64_t frames)>;

/// Measures the computing time on this machine: the median of repeated runs, as in the accuracy study. A run
/// of more than some milliseconds is only estimated from its first frames.
double measureTime(const sim::Script &script, std::int64_t frames);

/// Returns whether the run of `script` stays within `budget`. Steps of less than 1/128 frame never do.
bool staysWithin(const Budget &budget, const sim::Script &script, const TimeMeasurement &timing);

}
