#include "sim/effects/constraints/area_stick.h"

namespace sim {

std::vector<Region> AreaStick::regions(Directions) const
{
    return {{"sim/effects/constraints/area_stick.h", "area_stick"}, {"sim/base/direction.h", "direction"}};
}

int AreaStick::count(const State &state, Points points) const
{
    return points.contains(m_quad.right) && (state.feels(m_quad.left) || state.feels(m_quad.right)) ? 1 : 0;
}

void AreaStick::ties(std::vector<Tie> &into) const
{
    into.insert(into.end(),
                {{m_quad.front, m_quad.back}, {m_quad.back, m_quad.left}, {m_quad.left, m_quad.right}});
}

Sides AreaStick::sidesOf(const State &state) const
{
    const Heading spine =
        direction(state.at(m_quad.front) - state.at(m_quad.back), m_quad.back, m_quad.front);
    const double share = !state.feels(m_quad.left) ? 0.0 : !state.feels(m_quad.right) ? 1.0 : 0.5;
    return keepArea(state.at(m_quad.left), state.at(m_quad.right), spine, m_area, m_shortest, share);
}

void AreaStick::enforce(State &state, Points points, Directions, double) const
{
    if (count(state, points) == 0)
        return;
    const Sides sides = sidesOf(state);
    state.place(m_quad.left, sides.left);
    state.place(m_quad.right, sides.right);
}

std::vector<Live> AreaStick::explain(const State &before, const State &after, int point) const
{
    if (point != m_quad.left && point != m_quad.right)
        return {};
    const Sides sides = sidesOf(before);
    return {{"width", sides.width},
            {"wanted", sides.wanted},
            {"error", sides.error},
            {point == m_quad.left ? "left" : "right", after.at(point), before.at(point)}};
}

double areaOf(const State &state, const Quad &quad)
{
    const Vec2 spine = state.at(quad.front) - state.at(quad.back);
    const Vec2 wide = state.at(quad.right) - state.at(quad.left);
    return 0.5 * (spine.x * wide.y - spine.y * wide.x);
}

namespace described {
constinit const Description area_stick = {
    "area_stick", SIM_TEXT("area"), Kind::stick,
    SIM_TEXT("Keeps the area of the body: what gets longer gets thinner.")};
}

}
