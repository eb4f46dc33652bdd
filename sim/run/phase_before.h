#pragma once

#include "sim/run/track.h"

namespace sim {

/// Returns the state before the last finished phase of the current output step, or nothing if the cursor is
/// between two output steps. Computes the output step again from its start.
std::optional<State> stateBeforeLastPhase(const Track &track);

}
