#include "sim/run/sleeping/sleep_blocker.h"

#include "sim/pipeline/pipeline.h"

namespace sim {

SleepBlocker sleepBlockerOf(const Pipeline &pipeline, const State &state)
{
    if (const EffectPtr effect = preventsSleep(pipeline, state))
        return {SleepBlocker::Reason::time, effect};
    return {pipeline.step.isAdaptive() ? SleepBlocker::Reason::adaptiveSteps : SleepBlocker::Reason::nothing,
            nullptr};
}

}
