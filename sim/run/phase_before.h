#pragma once

#include "sim/run/track.h"

namespace sim {

/// Returns the state before the last phase that is done of the row under way; empty between two rows. Computes the row
/// again from its start.
std::optional<State> stateBeforeLastPhase(const Track &track);

}
