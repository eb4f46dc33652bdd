#include "sim/effects/drivers/turn_to_pointer.h"

#include "sim/base/direction.h"

namespace sim {

std::vector<Region> TurnToPointer::regions(DirectionRule) const
{
    if (m_formula == TreeFormula::published)
        return {{"sim/effects/tree/tree.h", "pointer_offset_published"},
                {"sim/effects/drivers/turn_to_pointer.h", "turn_to_pointer_published"},
                {"sim/effects/tree/tree.h", "reach"},
                {"sim/effects/tree/tree.h", "end"}};
    return {{"sim/base/direction.h", "direction"},
            {"sim/effects/drivers/turn_to_pointer.h", "turn_to_pointer"},
            {"sim/effects/tree/tree.h", "reach"},
            {"sim/effects/tree/tree.h", "end"}};
}

int TurnToPointer::count(const State &, PointRange points) const
{
    return points.count;
}

void TurnToPointer::drive(State &state, double) const
{
    if (!state.input.pointerDown || !state.input.pointer)
        return;
    const Vec2 pointer = *state.input.pointer;
    const double degrees = degreesOf(m_formula);
    if (m_formula == TreeFormula::published) {
        forEachFromTrunk(*m_tree, state, degrees, [&](int i) {
            const Vec2 reach = branchReach(state.angle[i], m_tree->baseLength, degrees);
            const double scale = m_tree->scaleOf(i);
            state.angle[i] =
                turnToPointerPublished(pointerOffsetPublished(pointer, state.positionOf(i), reach, scale).d);
        });
    } else {
        forEachFromTrunk(*m_tree, state, degrees, [&](int i) {
            state.angle[i] = turnToPointer(direction(pointer - state.positionOf(i), i, pointerIndex).out);
        });
    }
}

std::vector<LiveValue> TurnToPointer::explain(const State &before, const State &after, int point) const
{
    if (!after.input.pointerDown || !after.input.pointer || !after.isDynamic(point))
        return {};
    const Vec2 pointer = *after.input.pointer;
    std::vector<LiveValue> live;
    if (m_formula == TreeFormula::published) {
        const Vec2 reach = branchReach(before.angle[point], m_tree->baseLength, degreesOf(m_formula));
        const double scale = m_tree->scaleOf(point);
        const PointerOffset offset = pointerOffsetPublished(pointer, after.positionOf(point), reach, scale);
        live = {{"reach", reach, {}}, {"mouse", offset.mouse, {}}, {"d", offset.d, {}}};
    } else {
        const Direction heading = direction(pointer - after.positionOf(point), point, pointerIndex);
        live = {{"length", heading.length, {}}, {"out", heading.out, {}}};
    }
    live.push_back({"angle", after.angle[point], before.angle[point]});
    return live;
}

namespace descriptions {
constinit const EffectDescription turn_to_pointer = {
    "turn_to_pointer", SIM_TEXT("turn to the pointer"), EffectKind::driver,
    SIM_TEXT("Turns every branch to the pointer while its button is down.")};
}

}
