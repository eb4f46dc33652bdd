#pragma once

#include "sim/run/track.h"

namespace app {

/// Moves `run` towards `frame` for at most some milliseconds, so that the window does not wait for distant frames.
/// Returns whether `run` has reached `frame` or its end.
bool goNearer(sim::Track &run, std::int64_t frame);

}
