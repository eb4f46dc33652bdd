#include "sim/effects/drivers/pointer.h"

namespace sim {

namespace {

/// Returns the position of the dragged point (px): the pointer's position as soon as it is known.
/// Published: Ragdolls, constraints (the first two lines of each frame).
// Shown lines are short.
// clang-format off
//! [pointer]
Vec2 atPointer(
    Vec2 x, std::optional<Vec2> pointer)
{
    if (pointer) // known since it moved
        x = *pointer;
    return x;
}
//! [pointer]
// clang-format on

}

std::vector<Region> CarriedByPointer::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/pointer.cpp", "pointer"}};
}

int CarriedByPointer::count(const State &state, PointRange points) const
{
    return points.contains(m_point) && m_point < state.pointCount() ? 1 : 0;
}

void CarriedByPointer::drive(State &state, double) const
{
    if (state.isDynamic(m_point))
        state.place(m_point, atPointer(state.positionOf(m_point), state.input.pointer));
}

std::vector<LiveValue> CarriedByPointer::explain(const State &before, const State &after, int point) const
{
    if (point != m_point || before.positionOf(point) == after.positionOf(point))
        return {};
    return {{"x", after.positionOf(point), before.positionOf(point)}};
}

namespace descriptions {
constinit const EffectDescription pointer = {"pointer", SIM_TEXT("pointer"), EffectKind::driver,
                                             SIM_TEXT("Moves a point to the pointer.")};
}

}
