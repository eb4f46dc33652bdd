#include "sim/effects/ramp.h"

#include "sim/free_points.h"

#include <cmath>
#include <numbers>

namespace sim {

Incline inclineOf(Vec2 through, double angle, double bounce)
{
    const double rad = angle / 180.0 * std::numbers::pi;
    return {through, {-std::sin(rad), -std::cos(rad)}, bounce};
}

std::vector<Region> Ramp::regions(Directions) const
{
    return {{"sim/effects/ramp.h", "ramp"}, {"sim/effects/reflection.h", "reflection"}};
}

int Ramp::count(const State &state, Points points) const
{
    return static_cast<int>((state.inverseMass.segment(points.first, points.count) != 0.0).count());
}

std::vector<Surface> Ramp::surfaces(int point) const
{
    return {{m_edge.normal, dot(m_edge.through, m_edge.normal) + m_half[point], m_edge.bounce, Grip::none}};
}

void Ramp::resolve(State &state, Points points) const
{
    const Columns x(state.position), v(state.velocity);
    replaceFreeMotion(state, points, [=, half = m_half.data(), edge = m_edge](int i) {
        return ramp(x.at(i), v.at(i), half[i], edge);
    });
}

}
