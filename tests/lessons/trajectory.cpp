#include "tests/lessons/trajectory.h"

#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <algorithm>

namespace support {

Course courseOf(const sim::Script &script, const std::string &body, int from, int to)
{
    sim::Track track(script, 0);
    track.seek({from, 0});
    const int point = track.interval().scene.find(body);
    const double start = track.state().positionOf(point).x;
    Course integrator;
    for (int frame = from; frame <= to; ++frame) {
        track.seek({frame, 0});
        const sim::Vec2 at = track.state().positionOf(point);
        integrator.top = std::min(integrator.top, at.y);
        integrator.bottom = std::max(integrator.bottom, at.y);
        integrator.left = std::min(integrator.left, at.x);
        integrator.right = std::max(integrator.right, at.x);
    }
    integrator.pace = (track.state().positionOf(point).x - start) / (to - from);
    return integrator;
}

}
