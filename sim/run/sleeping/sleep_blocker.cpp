#include "sim/run/sleeping/sleep_blocker.h"

#include "sim/pipeline/pipeline.h"

namespace sim {

Awake awakeBy(const Pipeline &pipeline, const State &state)
{
    if (const EffectPtr effect = keepsAwake(pipeline, state))
        return {Awake::Why::time, effect};
    return {pipeline.step.adaptive() ? Awake::Why::ownSteps : Awake::Why::nothing, nullptr};
}

}
