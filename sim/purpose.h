#pragma once

#include "sim/effect.h"

namespace sim {

/// What `effect` is there for: one sentence for a learner, in English; see SIM_TEXT. Empty for one that none is
/// written of.
std::string purposeOf(const Effect &effect);

}
