#pragma once

#include "sim/run/script/composed_intervals.h"

namespace sim {

/// Takes `state`, at the end of a row of `before`, into the row of `now` that ends at `rowEnd`: carries it over where a
/// parameter changes, applies the row's input, and moves what a hand holds.
void beginOutputStep(State &state, const Script &script,
                     const std::shared_ptr<const ComposedInterval> &before,
                     const std::shared_ptr<const ComposedInterval> &now, std::int64_t outputEnd);

/// Whether a parameter is set, to whatever value, at the start of the row that ends at `rowEnd`.
bool setsParameters(const Script &script, std::int64_t outputEnd);

/// The points that a hand takes hold of at the start of the row that ends at `rowEnd`.
std::vector<int> grabbedPoints(const Script &script, const Scene &scene, std::int64_t outputEnd);

/// The end of the first row after `frame` that begins with input; empty if there is none.
std::optional<std::int64_t> nextInputFrame(const Script &script, std::int64_t frame);

}
