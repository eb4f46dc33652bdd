#include "sim/pipeline/phase_builder.h"

namespace sim {

namespace {

/// Adds a force to the accelerations gathered so far.
// Shown lines are short.
// clang-format off
//! [gather]
void gather(
    const Force &force, State &state,
    PointRange movers, double)
{
    force.add(state, movers, 1.0,
        DirectionRule::regularised,
        state.acceleration);
}
//! [gather]
// clang-format on

/// Adds a torque to the angular accelerations gathered so far.
// Shown lines are short.
// clang-format off
//! [gather_torque]
void gatherTorque(
    const Torque &torque, State &state,
    PointRange movers, double)
{
    torque.add(state, movers, 1.0,
        state.angularAcceleration);
}
//! [gather_torque]
// clang-format on

}

ForceAccumulation accelerationAccumulation()
{
    return {gather,
            gatherTorque,
            {"sim/pipeline/force_accumulation.cpp", "gather"},
            {"sim/pipeline/force_accumulation.cpp", "gather_torque"},
            AccumulationTarget::acceleration};
}

}
