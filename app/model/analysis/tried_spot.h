#pragma once

#include "lessons/api/step.h"

#include <vector>

namespace app {

/// A setting that the learner has tried: a place on a map.
struct TriedSpot
{
    double k = 0.0;    ///< 1/frame^2
    double damp = 1.0; ///< fraction kept per frame
    double h = 1.0;    ///< frames
    friend bool operator==(const TriedSpot &, const TriedSpot &) = default;
};

/// Adds `spot` to the settings that were tried, oldest first, unless it is the last one. Returns whether it was added. The
/// oldest ones are dropped.
bool addTried(std::vector<TriedSpot> &tried, const TriedSpot &spot);
/// Returns the parameter across a map, or null: the stiffness of the step.
const lessons::Parameter *stiffnessOf(const lessons::Step &step);
/// Returns the parameter that damps, or null.
const lessons::Parameter *dampingOf(const lessons::Step &step);

/// Returns the nearest settings to `spot` that are possible in `step`: numbers with the digits of their fields, within
/// their ranges, and a valid step.
TriedSpot settable(const lessons::Step &step, TriedSpot spot);

}
