#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <vector>

namespace app {

/// The guides of a step for one moment of `track`: those of the state, then those of the run. Guides that cannot be
/// drawn, as a pull over 1e308 px is no number any more, are left out.
std::vector<lessons::Overlay> guidesOf(const lessons::Step &step, const sim::Track &track,
                                       const sim::ComposedInterval &interval, const sim::State &state);

}
