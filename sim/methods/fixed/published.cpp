#include "sim/methods/fixed/published.h"

#include "sim/pipeline/phase_builder.h"

namespace sim {

namespace {

/// How the published code adds up forces: each pull goes onto the velocity at once. The order of these sums is
/// part of what it computes.
// Shown lines are short.
// clang-format off
//! [published_forces]
void pullAtOnce(
    const Force &force, State &state,
    Points movers, double h)
{
    // onto the velocity, pull after pull
    force.add(state, movers, h,
        Directions::published,
        state.velocity);
}
//! [published_forces]
// clang-format on

/// The same for what turns.
// Shown lines are short.
// clang-format off
//! [published_torques]
void turnAtOnce(
    const Torque &torque, State &state,
    Points movers, double h)
{
    // onto the spin, at once
    torque.add(state, movers, h,
        state.spin);
}
//! [published_torques]
// clang-format on

}

void Published::prepare(State &state) const
{
    state.acceleration.resize(0, 2);
    state.turning.resize(0);
}

std::vector<Phase> Published::phases(const Scene &scene, StepSize size) const
{
    PhaseList step(scene, directions(), size.h);
    const Adding pull = {pullAtOnce,
                         turnAtOnce,
                         {"sim/methods/fixed/published.cpp", "published_forces"},
                         {"sim/methods/fixed/published.cpp", "published_torques"},
                         Onto::velocity};
    //! [published_order]
    step.driversFirst();
    // each group sees what has already moved
    for (const Share &group : step.groups()) {
        // forces and damping
        step.asListed(group, pull);
        step.move(group);
        step.constraints(group);
        step.contacts(group);
    }
    step.driversLast();
    //! [published_order]
    return step.take();
}

}
