#include "app/model/stability_reading.h"

#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

#include <utility>

namespace app {

StabilityReading readStability(const sim::Script &script,
                               std::shared_ptr<const sim::ComposedInterval> interval, const sim::State &state)
{
    StabilityReading reading;
    try {
        reading.stability = sim::stabilityOf(interval->scene, state, *script.method, script.step.h);
    } catch (const sim::Error &) {
        reading.stability.bound = sim::Bound::unknown; // no such scene: the session says why
    }
    reading.interval = std::move(interval);
    reading.method = script.method;
    reading.step = script.step;
    return reading;
}

}
