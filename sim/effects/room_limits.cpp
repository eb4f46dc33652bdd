#include "sim/effects/room_limits.h"

namespace sim {

std::vector<Region> RoomLimits::regions(Directions) const
{
    return {{"sim/effects/room_limits.h", "room_limits"}, {"sim/effects/room_limits.h", "friction"}};
}

int RoomLimits::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void RoomLimits::enforce(State &state, Points points, Directions, double) const
{
    const bool remembers = state.previous.rows() == state.points();
    for (int i = points.first; i < points.end(); ++i) {
        if (!state.feels(i))
            continue;
        const Vec2 x = state.at(i);
        const Vec2 before = remembers ? Vec2{state.previous(i, 0), state.previous(i, 1)} : x;
        state.place(i, keepInside(x, before, m_half[i], m_room, m_friction));
    }
}

std::vector<Live> RoomLimits::explain(const State &before, const State &after, int point) const
{
    if (before.at(point) == after.at(point))
        return {};
    return {{"x", after.at(point), before.at(point)}};
}

}
