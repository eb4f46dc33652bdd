#include "lessons/api/checks/input_queries.h"

namespace lessons {

std::span<const sim::Event> appliedInput(const sim::Timeline &timeline)
{
    return appliedInput(timeline.track());
}

std::span<const sim::Event> appliedInput(const sim::Track &track)
{
    const sim::Cursor cursor = track.cursor();
    const std::int64_t lastFrame = cursor.phase > 0 ? cursor.frame + track.framesPerOutput() : cursor.frame;
    if (lastFrame == 0)
        return {};
    const std::vector<sim::Event> &input = track.script().input;
    const auto end = std::find_if(input.begin(), input.end(),
                                  [&](const sim::Event &event) { return event.frame > lastFrame; });
    return {input.begin(), end};
}

bool isReleased(const sim::Track &track, const std::string &body)
{
    bool isFree = false, isMeant = false;
    for (const sim::Event &event : appliedInput(track)) {
        if (const auto *grab = std::get_if<sim::Grab>(&event.what)) {
            isFree = false;
            isMeant = body.empty() || grab->body == body;
        } else if (std::holds_alternative<sim::Release>(event.what)) {
            isFree = true;
        }
    }
    return isFree && isMeant;
}

}
