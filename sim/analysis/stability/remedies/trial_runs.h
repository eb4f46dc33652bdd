#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/run/track.h"

namespace sim {

/// Returns remedies for `script`, which stopped at `stop`: for each kind the smallest change from the start
/// on that is stable in a trial run past that frame. A kind without a stable trial is left out. A change
/// whose trial would take too long is included with Remedy::stableFrames 0. Stops early, with the remedies
/// found so far, when `shouldContinue` returns false.
/// @param damp null if the scene has no such parameter
/// @throws nothing: a change that does not compose is left out
std::vector<Remedy> remediesAfter(const Script &script, const Stop &stop, const DampRange *damp,
                                  const ShouldContinue &shouldContinue);

}
