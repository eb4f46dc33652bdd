#include "sim/methods/semi_implicit_euler.h"

#include "sim/methods/parts.h"

namespace sim {

namespace {

/// Adds a force to the accelerations gathered so far.
//! [gather]
void gather(const Force &force, State &state)
{
    const Points all = {0, state.points()};
    force.add(state, all, 1.0, Directions::apart, state.acceleration);
}
//! [gather]

}

void SemiImplicitEuler::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
}

std::vector<Phase> SemiImplicitEuler::phases(const Scene &scene, double h) const
{
    std::vector<Phase> phases;
    const Share all = everything(scene);
    const Region shown = {"sim/methods/semi_implicit_euler.cpp", "gather"};
    //! [semi_implicit_order]
    // All points at once: every force sees the same positions.
    addForcePhases(phases, scene, all, directions(), shown, gather);
    addKickPhase(phases, scene, all, h);
    addDampPhases(phases, scene, all, directions(), h);
    addMovePhase(phases, scene, all, h);
    addContactPhases(phases, scene, all, directions());
    //! [semi_implicit_order]
    if (!phases.empty()) {
        const auto first = phases.front().run;
        phases.front().run = [first](State &state) {
            state.acceleration.setZero();
            first(state);
        };
    }
    return phases;
}

}
