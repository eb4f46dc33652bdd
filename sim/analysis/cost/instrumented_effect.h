#pragma once

#include "sim/analysis/cost/call_counter.h"

namespace sim {

/// Returns an effect that does the same as `effect` and counts the calls to it in `counter`, which must
/// outlive it. It is used for measuring only, never in a real run.
EffectPtr instrumented(const EffectPtr &effect, CallCounter &counter);

}
