#include "lessons/api/checks/input_queries.h"

namespace lessons {

std::span<const sim::Event> appliedInput(const sim::Timeline &timeline)
{
    const sim::Cursor cursor = timeline.cursor();
    const std::int64_t lastFrame =
        cursor.phase > 0 ? cursor.frame + timeline.track().framesPerOutput() : cursor.frame;
    if (lastFrame == 0)
        return {};
    const std::vector<sim::Event> &input = timeline.script().input;
    const auto end = std::find_if(input.begin(), input.end(),
                                  [&](const sim::Event &event) { return event.frame > lastFrame; });
    return {input.begin(), end};
}

}
