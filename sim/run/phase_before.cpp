#include "sim/run/phase_before.h"

#include "sim/run/script/composed_interval.h"
#include "sim/simd/flush_denormals.h"

namespace sim {

std::optional<State> beforeLastPhase(const Track &track)
{
    const Cursor at = track.at();
    if (at.phase == 0)
        return {};
    const FlushTiny flush;
    State state = track.begunAfter(track.stateAt(at.frame), at.frame);
    const std::shared_ptr<const Segment> segment = track.next();
    for (int i = 0; i + 1 < at.phase; ++i)
        segment->pipeline.phaseAt(i).run(state);
    return state;
}

}
