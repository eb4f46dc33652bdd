#include "tests/lessons/trajectory.h"

#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <algorithm>

namespace support {

Course courseOf(const sim::Script &script, const std::string &body, int from, int to)
{
    sim::Track track(script, 0);
    track.seek({from, 0});
    const int point = track.shown().scene.find(body);
    const double start = track.now().at(point).x;
    Course course;
    for (int frame = from; frame <= to; ++frame) {
        track.seek({frame, 0});
        const sim::Vec2 at = track.now().at(point);
        course.top = std::min(course.top, at.y);
        course.bottom = std::max(course.bottom, at.y);
        course.left = std::min(course.left, at.x);
        course.right = std::max(course.right, at.x);
    }
    course.pace = (track.now().at(point).x - start) / (to - from);
    return course;
}

}
