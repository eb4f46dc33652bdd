#include "sim/catalogue/hard_case.h"

#include "sim/pipeline/method.h"

#include <algorithm>

namespace sim {

bool HardCase::hasRequirement(Requirement requirement) const
{
    return std::find(requirements.begin(), requirements.end(), requirement) != requirements.end();
}

const Rest *HardCase::restAfter(const RunSize &size) const
{
    return rest && size.frames >= rest->after ? &*rest : nullptr;
}

Script scriptOf(const HardCase &hardCase, const MethodPtr &method, const RunSize &size)
{
    Script script = hardCase.script;
    script.method = method;
    script.step = method->stepping() == Stepping::adaptive ? StepSize::withTolerance(size.tolerance)
                                                           : StepSize::ofLength(size.h);
    return script;
}

}
