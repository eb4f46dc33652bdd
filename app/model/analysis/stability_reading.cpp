#include "app/model/analysis/stability_reading.h"

#include "app/model/run/run_program.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

#include <utility>

namespace app {

StabilityReading readStability(const sim::Script &script,
                               std::shared_ptr<const sim::ComposedInterval> interval, const sim::State &state)
{
    StabilityReading reading;
    try {
        if (!programOf(
                script
                    .method)) // code can compute anything, so the springs of the scene tell nothing about it
            reading.stability = sim::stabilityOf(interval->scene, state, *script.method, script.step.h);
    } catch (const sim::Error &) {
        // The scene cannot be set up: the session reports the reason.
        reading.stability.bound = sim::Bound::unknown;
    }
    reading.interval = std::move(interval);
    reading.method = script.method;
    reading.step = script.step;
    return reading;
}

}
