#include "sim/run/phase_before.h"

#include "sim/run/script/composed_interval.h"
#include "sim/simd/flush_denormals.h"

namespace sim {

std::optional<State> stateBeforeLastPhase(const Track &track)
{
    const Cursor cursor = track.cursor();
    if (cursor.phase == 0)
        return {};
    const FlushDenormals flush;
    State state = track.stateAfterInput(track.stateAt(cursor.frame), cursor.frame);
    const std::shared_ptr<const ComposedInterval> interval = track.nextInterval();
    for (int i = 0; i + 1 < cursor.phase; ++i)
        interval->pipeline.phaseAt(i).run(state);
    return state;
}

}
