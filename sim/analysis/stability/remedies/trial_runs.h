#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/run/track.h"

namespace sim {

/// What mends `script`, which stopped at `stop`: of each kind the mildest change from the start on that holds in a
/// trial past that frame, and none of a kind that fails. One whose trial would take too long is not known to fail: it
/// is offered with Remedy::stableFrames 0. Leaves off, with what it has, when `goesOn` says no.
/// @param damp null where the scene has no such parameter
/// @throws nothing: what does not compose is no remedy
std::vector<Remedy> remediesAfter(const Script &script, const Stop &stop, const DampRange *damp,
                                  const ShouldContinue &shouldContinue);

}
