#include "sim/effects/drivers/pointer.h"

namespace sim {

namespace {

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

std::vector<Region> CarriedByPointer::regions(Directions) const
{
    return {{"sim/effects/drivers/pointer.cpp", "pointer"}};
}

int CarriedByPointer::count(const State &state, Points points) const
{
    return points.contains(m_point) && m_point < state.points() ? 1 : 0;
}

void CarriedByPointer::drive(State &state, double) const
{
    if (state.feels(m_point))
        state.place(m_point, atPointer(state.at(m_point), state.outside.pointer));
}

std::vector<Live> CarriedByPointer::explain(const State &before, const State &after, int point) const
{
    if (point != m_point || before.at(point) == after.at(point))
        return {};
    return {{"x", after.at(point), before.at(point)}};
}

namespace described {
constinit const Description pointer = {"pointer", SIM_TEXT("pointer"), Kind::driver,
                                       SIM_TEXT("Carries a point to where the pointer is.")};
}

}
