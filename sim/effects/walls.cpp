#include "sim/effects/walls.h"

namespace sim {

std::vector<Region> Walls::regions(Directions) const
{
    return {{"sim/effects/walls.h", "walls"}};
}

int Walls::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

void Walls::resolve(State &state, Points points) const
{
    for (int i = points.first; i < points.end(); ++i) {
        if (!state.feels(i))
            continue;
        const Motion after = walls(state.at(i), state.speed(i), m_half[i], m_room);
        state.place(i, after.x);
        state.push(i, after.v);
    }
}

}
