#include "app/model/same_run.h"

#include <algorithm>
#include <limits>

namespace app {

bool sameRun(const sim::Script &a, const sim::Script &b)
{
    return a.method == b.method && a.step == b.step && a.values == b.values && a.bodies == b.bodies &&
           a.effectsOff == b.effectsOff;
}

sim::Script withoutInput(const sim::Script &script)
{
    sim::Script plain;
    plain.values = script.values;
    plain.bodies = script.bodies;
    plain.effectsOff = script.effectsOff;
    plain.method = script.method;
    plain.step = script.step;
    return plain;
}

std::int64_t firstDifference(const std::vector<sim::Event> &a, const std::vector<sim::Event> &b)
{
    const auto [one, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    std::int64_t frame = std::numeric_limits<std::int64_t>::max();
    if (one != a.end())
        frame = std::min(frame, one->frame);
    if (other != b.end())
        frame = std::min(frame, other->frame);
    return frame;
}

}
