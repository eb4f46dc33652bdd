#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <vector>

namespace app {

/// Returns the overlays of a step for one moment of `track`: those of the state, then those of the run. Overlays
/// with values that are not finite are omitted, for example a pull over 1e308 px.
std::vector<lessons::Overlay> overlaysOf(const lessons::Step &step, const sim::Track &track,
                                         const sim::ComposedInterval &interval, const sim::State &state);

}
