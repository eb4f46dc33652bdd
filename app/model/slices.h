#pragma once

#include "sim/run/track.h"

namespace app {

/// Takes `run` nearer to `frame` for some milliseconds, so that a window never waits for a far one. Returns whether it is
/// there, or at its end.
bool goNearer(sim::Track &run, std::int64_t frame);

}
