#include "app/model/guides.h"

#include "lessons/api/view/scene_view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <cmath>

namespace app {

namespace {

bool canBeDrawn(const lessons::Guide &guide)
{
    return std::isfinite(guide.a.x) && std::isfinite(guide.a.y) && std::isfinite(guide.b.x) &&
           std::isfinite(guide.b.y) && std::isfinite(guide.size);
}

}

std::vector<lessons::Guide> guidesOf(const lessons::Step &step, const sim::Track &track,
                                     const sim::Segment &segment, const sim::State &state)
{
    std::vector<lessons::Guide> guides;
    if (step.guides)
        guides = step.guides(segment.scene, state, segment.values);
    if (step.guidesOfRun) {
        const sim::Cursor at = track.at();
        const std::int64_t frame = at.phase > 0 ? at.frame + track.rowFrames() : at.frame;
        const std::vector<lessons::Guide> more = step.guidesOfRun(track.script(), state, frame);
        guides.insert(guides.end(), more.begin(), more.end());
    }
    std::erase_if(guides, [](const lessons::Guide &guide) { return !canBeDrawn(guide); });
    return guides;
}

}
