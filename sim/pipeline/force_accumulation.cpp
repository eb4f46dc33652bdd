#include "sim/pipeline/phase_builder.h"

namespace sim {

namespace {

/// Adds a force to the accelerations.
// Shown lines are short.
// clang-format off
//! [sum_forces]
void accumulateForce(
    const Force &force, State &state,
    PointRange movers, double)
{
    force.add(state, movers, 1.0,
        DirectionRule::regularised,
        state.acceleration);
}
//! [sum_forces]
// clang-format on

/// Adds a torque to the angular accelerations.
// Shown lines are short.
// clang-format off
//! [sum_torques]
void accumulateTorque(
    const Torque &torque, State &state,
    PointRange movers, double)
{
    torque.add(state, movers, 1.0,
        state.angularAcceleration);
}
//! [sum_torques]
// clang-format on

}

ForceAccumulation accelerationAccumulation()
{
    return {accumulateForce,
            accumulateTorque,
            {"sim/pipeline/force_accumulation.cpp", "sum_forces"},
            {"sim/pipeline/force_accumulation.cpp", "sum_torques"},
            AccumulationTarget::acceleration};
}

}
