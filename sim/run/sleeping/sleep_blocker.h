#pragma once

#include "sim/run/sleeping/sleep.h"

namespace sim {

/// The reason why a scene at rest does not sleep.
struct SleepBlocker
{
    enum class Reason {
        nothing,       ///< it sleeps
        time,          ///< an effect depends on the frame number, for example a random one
        adaptiveSteps, ///< an adaptive method hardly ever repeats the same bits, even at rest
    };
    Reason reason = Reason::nothing;
    EffectPtr effect; ///< the effect that depends on the frame number, else null
};

/// Returns why a scene that rests in `state` and is computed by `pipeline` does not sleep.
SleepBlocker sleepBlockerOf(const Pipeline &pipeline, const State &state);

}
