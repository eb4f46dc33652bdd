#pragma once

#include "sim/run/script/composed_intervals.h"

namespace sim {

/// Prepares `state`, the end of an output step in interval `before`, for the output step in interval `now`
/// that ends at `outputEnd`. Transfers it to the new scene if a parameter is set, applies the input of the
/// output step, and moves the dragged point.
void beginOutputStep(State &state, const Script &script,
                     const std::shared_ptr<const ComposedInterval> &before,
                     const std::shared_ptr<const ComposedInterval> &now, std::int64_t outputEnd);

/// Returns whether the input of the output step that ends at `outputEnd` sets a parameter, even to its
/// current value.
bool setsParameters(const Script &script, std::int64_t outputEnd);

/// Returns the points that the learner grabs at the start of the output step that ends at `outputEnd`. An
/// entry is -1 if no such body exists.
std::vector<int> grabbedPoints(const Script &script, const Scene &scene, std::int64_t outputEnd);

/// Returns the end of the first output step after `frame` that has input, or nothing.
std::optional<std::int64_t> nextInputFrame(const Script &script, std::int64_t frame);

}
