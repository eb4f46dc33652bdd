#include "app/model/picture/overlays.h"

#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <cmath>

namespace app {

namespace {

bool canBeDrawn(const lessons::Overlay &overlay)
{
    return std::isfinite(overlay.a.x) && std::isfinite(overlay.a.y) && std::isfinite(overlay.b.x) &&
           std::isfinite(overlay.b.y) && std::isfinite(overlay.size);
}

}

std::vector<lessons::Overlay> overlaysOf(const lessons::Step &step, const sim::Track &track,
                                         const sim::ComposedInterval &interval, const sim::State &state)
{
    std::vector<lessons::Overlay> overlays;
    if (step.overlays)
        overlays = step.overlays(interval.scene, state, interval.values);
    if (step.runOverlays) {
        const sim::Cursor at = track.cursor();
        const std::int64_t frame = at.phase > 0 ? at.frame + track.framesPerOutput() : at.frame;
        const std::vector<lessons::Overlay> more = step.runOverlays(track.script(), state, frame);
        overlays.insert(overlays.end(), more.begin(), more.end());
    }
    std::erase_if(overlays, [](const lessons::Overlay &overlay) { return !canBeDrawn(overlay); });
    return overlays;
}

}
