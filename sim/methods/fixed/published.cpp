#include "sim/methods/fixed/published.h"

#include "sim/pipeline/phase_builder.h"

namespace sim {

namespace {

/// Adds each force to the velocity at once, as the tutorials do. The order of these sums affects the result.
// Shown lines are short.
// clang-format off
//! [published_forces]
void pullAtOnce(
    const Force &force, State &state,
    PointRange movers, double h)
{
    // onto the velocity, pull after pull
    force.add(state, movers, h,
        DirectionRule::published,
        state.velocity);
}
//! [published_forces]
// clang-format on

/// Adds each torque to the spin at once.
// Shown lines are short.
// clang-format off
//! [published_torques]
void turnAtOnce(
    const Torque &torque, State &state,
    PointRange movers, double h)
{
    // onto the spin, at once
    torque.add(state, movers, h,
        state.spin);
}
//! [published_torques]
// clang-format on

}

void Published::prepareState(State &state) const
{
    state.acceleration.resize(0, 2);
    state.angularAcceleration.resize(0);
}

std::vector<Phase> Published::phases(const Scene &scene, StepSize size) const
{
    PhaseBuilder step(scene, directionRule(), size.h);
    const ForceAccumulation pull = {pullAtOnce,
                                    turnAtOnce,
                                    {"sim/methods/fixed/published.cpp", "published_forces"},
                                    {"sim/methods/fixed/published.cpp", "published_torques"},
                                    AccumulationTarget::velocity};
    //! [published_order]
    step.leadingDrivers();
    // each group sees what has already moved
    for (const PhasePoints &group : step.groups()) {
        // forces and damping
        step.effectsInSceneOrder(group, pull);
        step.move(group);
        step.constraints(group);
        step.contacts(group);
    }
    step.trailingDrivers();
    //! [published_order]
    return step.take();
}

}
