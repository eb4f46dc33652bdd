#pragma once

#include "sim/analysis/cost/call_counter.h"

namespace sim {

/// An effect that does all that `effect` does, and notes in `tally`, which must outlive it, what it is asked. For
/// measuring only: what runs is always the effect itself.
EffectPtr instrumented(const EffectPtr &effect, CallCounter &counter);

}
