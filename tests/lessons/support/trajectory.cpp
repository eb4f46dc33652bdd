#include "tests/lessons/support/trajectory.h"

#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <algorithm>

namespace support {

MotionSummary motionOf(const sim::Script &script, const std::string &body, int from, int to)
{
    sim::Track track(script, 0);
    track.seek({from, 0});
    const int point = track.interval().scene.find(body);
    const double start = track.state().positionOf(point).x;
    MotionSummary motion;
    for (int frame = from; frame <= to; ++frame) {
        track.seek({frame, 0});
        const sim::Vec2 position = track.state().positionOf(point);
        motion.top = std::min(motion.top, position.y);
        motion.bottom = std::max(motion.bottom, position.y);
        motion.left = std::min(motion.left, position.x);
        motion.right = std::max(motion.right, position.x);
    }
    motion.meanVelocity = (track.state().positionOf(point).x - start) / (to - from);
    return motion;
}

sim::Vec2 momentumOf(const sim::State &state)
{
    return {state.velocity.col(0).sum(), state.velocity.col(1).sum()};
}

}
