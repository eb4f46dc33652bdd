#include "sim/methods/published.h"

#include "sim/methods/parts.h"

namespace sim {

namespace {

/// How the published code adds up forces: each pull goes onto the velocity at once. The order of these sums is
/// part of what it computes.
//! [published_forces]
void pullAtOnce(const Force &force, State &state, Points movers, double h)
{
    force.add(state, movers, h, Directions::published, state.velocity);
}
//! [published_forces]

}

void Published::prepare(State &state) const
{
    state.acceleration.resize(0, 2);
}

std::vector<Phase> Published::phases(const Scene &scene, double h) const
{
    std::vector<Phase> phases;
    const Region forces = {"sim/methods/published.cpp", "published_forces"};
    //! [published_order]
    // One group after the other: each sees what has already moved.
    for (int group = 0; group < static_cast<int>(scene.groups.size()); ++group) {
        const Points points = scene.groups[static_cast<std::size_t>(group)].points;
        const Share share = {points, group};
        addForcePhases(
            phases, scene, share, directions(), forces,
            [points, h](const Force &force, State &state) { pullAtOnce(force, state, points, h); });
        addDampPhases(phases, scene, share, directions(), h);
        addMovePhase(phases, scene, share, h);
        addContactPhases(phases, scene, share, directions());
    }
    //! [published_order]
    return phases;
}

}
