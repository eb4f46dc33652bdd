#pragma once

#include "sim/run/sleeping/sleep.h"

namespace sim {

/// What keeps a scene from falling asleep when it has come to rest.
struct SleepBlocker
{
    enum class Reason {
        nothing,       ///< it falls asleep
        time,          ///< an effect looks at the number of the frame: what is random, say
        adaptiveSteps, ///< the method chooses its steps: at rest, too, they hardly ever lead to the same bits again
    };
    Reason reason = Reason::nothing;
    EffectPtr effect; ///< the one that looks; else null
};

/// What keeps awake what is computed by `pipeline` and rests in `state`.
SleepBlocker sleepBlockerOf(const Pipeline &pipeline, const State &state);

}
