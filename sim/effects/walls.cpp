#include "sim/effects/walls.h"

#include "sim/free_points.h"

namespace sim {

std::vector<Region> Walls::regions(Directions) const
{
    return {{"sim/effects/walls.h", "walls"}};
}

int Walls::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

std::vector<Surface> Walls::surfaces(int point) const
{
    const double half = m_half[point];
    return {{{-1.0, 0.0}, half - m_room.right, m_room.bounce, Grip::none},
            {{1.0, 0.0}, m_room.left + half, m_room.bounce, Grip::none},
            {{0.0, -1.0}, half - m_room.floor, m_room.bounce, Grip::none}};
}

void Walls::resolve(State &state, Points points) const
{
    const Columns x(state.position), v(state.velocity);
    replaceFreeMotion(state, points, [=, half = m_half.data(), room = m_room](int i) {
        return walls(x.at(i), v.at(i), half[i], room);
    });
}

}
