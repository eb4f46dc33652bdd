#include "app/model/guides.h"

#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <cmath>

namespace app {

namespace {

bool canBeDrawn(const lessons::Overlay &guide)
{
    return std::isfinite(guide.a.x) && std::isfinite(guide.a.y) && std::isfinite(guide.b.x) &&
           std::isfinite(guide.b.y) && std::isfinite(guide.size);
}

}

std::vector<lessons::Overlay> guidesOf(const lessons::Step &step, const sim::Track &track,
                                       const sim::ComposedInterval &interval, const sim::State &state)
{
    std::vector<lessons::Overlay> guides;
    if (step.overlays)
        guides = step.overlays(interval.scene, state, interval.values);
    if (step.runOverlays) {
        const sim::Cursor at = track.cursor();
        const std::int64_t frame = at.phase > 0 ? at.frame + track.framesPerOutput() : at.frame;
        const std::vector<lessons::Overlay> more = step.runOverlays(track.script(), state, frame);
        guides.insert(guides.end(), more.begin(), more.end());
    }
    std::erase_if(guides, [](const lessons::Overlay &guide) { return !canBeDrawn(guide); });
    return guides;
}

}
