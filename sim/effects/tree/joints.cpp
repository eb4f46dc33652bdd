#include "sim/effects/tree/joints.h"

#include "sim/effects/tree/tree_walk.h"

namespace sim {

std::vector<Region> Joints::regions(DirectionRule) const
{
    return {{"sim/effects/tree/tree.h", "reach"}, {"sim/effects/tree/tree.h", "end"}};
}

int Joints::count(const State &, PointRange points) const
{
    return points.count;
}

void Joints::drive(State &state, double) const
{
    TreeWalk walk(*m_tree, state, m_degrees);
    for (PointRange range = walk.next({}); range.count > 0; range = walk.next(range))
        walk.moveChildren(range);
    if (state.spin.rows() > 0)
        state.spin = (state.inverseMass == 0.0).select(0.0, state.spin);
}

std::vector<LiveValue> Joints::explain(const State &, const State &after, int point) const
{
    const double scale = m_tree->scaleOf(point);
    const Vec2 reach = branchReach(after.angle[point], m_tree->baseLength, m_degrees);
    return {{"angle", after.angle[point], {}},
            {"rad", after.angle[point] / m_degrees, {}},
            {"reach", reach, {}},
            {"scale", scale, {}},
            {"end", branchEnd(after.positionOf(point), reach, scale), {}}};
}

namespace descriptions {
constinit const EffectDescription joints = {
    "joints", SIM_TEXT("joints"), EffectKind::stick,
    SIM_TEXT("Set each branch on the end of the branch that carries it.")};
}

}
