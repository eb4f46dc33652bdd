#pragma once

#include "sim/scene/scene.h"

namespace sim {

/// Returns `state` of scene `from`, transferred to scene `to`. Bodies of the same name keep their motion, and
/// turn by the difference of their initial angles. New bodies get the initial state of `to`, shifted by the
/// mean displacement of the others. If the initial positions or angles differ, dependent drivers run: the branches of a
/// tree stay together.
State transferState(const State &state, const Scene &from, const Scene &to);

}
