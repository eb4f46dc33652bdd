#include "sim/methods/published.h"

#include "sim/methods/parts.h"

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

}

void Published::prepare(State &state) const
{
    state.acceleration.resize(0, 2);
}

std::vector<Phase> Published::phases(const Scene &scene, double h) const
{
    PhaseList step(scene, directions(), h);
    const Region pull = {"sim/methods/published.cpp", "published_forces"};
    //! [published_order]
    // each group sees what has already moved
    for (const Share &group : step.groups()) {
        step.forces(group, pullAtOnce, pull);
        step.damping(group);
        step.move(group);
        step.contacts(group);
    }
    //! [published_order]
    return step.take();
}

}
