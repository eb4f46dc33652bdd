#include "sim/effects/constraints/area_stick.h"

namespace sim {

std::vector<Region> AreaStick::regions(DirectionRule) const
{
    return {{"sim/effects/constraints/area_stick.h", "area_stick"}, {"sim/base/direction.h", "direction"}};
}

int AreaStick::count(const State &state, PointRange points) const
{
    return points.contains(m_quad.right) && (state.isDynamic(m_quad.left) || state.isDynamic(m_quad.right))
               ? 1
               : 0;
}

void AreaStick::addCouplings(std::vector<Coupling> &into) const
{
    into.insert(into.end(),
                {{m_quad.front, m_quad.back}, {m_quad.back, m_quad.left}, {m_quad.left, m_quad.right}});
}

Sides AreaStick::sidesOf(const State &state) const
{
    const Direction spine =
        direction(state.positionOf(m_quad.front) - state.positionOf(m_quad.back), m_quad.back, m_quad.front);
    const double share = !state.isDynamic(m_quad.left) ? 0.0 : !state.isDynamic(m_quad.right) ? 1.0 : 0.5;
    return keepArea(state.positionOf(m_quad.left), state.positionOf(m_quad.right), spine, m_area, m_shortest,
                    share);
}

void AreaStick::enforce(State &state, PointRange points, DirectionRule, double) const
{
    if (count(state, points) == 0)
        return;
    const Sides sides = sidesOf(state);
    state.place(m_quad.left, sides.left);
    state.place(m_quad.right, sides.right);
}

std::vector<LiveValue> AreaStick::explain(const State &before, const State &after, int point) const
{
    if (point != m_quad.left && point != m_quad.right)
        return {};
    const Sides sides = sidesOf(before);
    return {{"width", sides.width},
            {"wanted", sides.wanted},
            {"error", sides.error},
            {point == m_quad.left ? "left" : "right", after.positionOf(point), before.positionOf(point)}};
}

double areaOf(const State &state, const Quad &quad)
{
    const Vec2 spine = state.positionOf(quad.front) - state.positionOf(quad.back);
    const Vec2 width = state.positionOf(quad.right) - state.positionOf(quad.left);
    return 0.5 * (spine.x * width.y - spine.y * width.x);
}

namespace descriptions {
constinit const EffectDescription area_stick = {
    "area_stick", SIM_TEXT("area"), EffectKind::stick,
    SIM_TEXT("Keeps the area of the body: what gets longer gets thinner.")};
}

}
