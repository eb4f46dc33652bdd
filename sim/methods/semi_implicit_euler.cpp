#include "sim/methods/semi_implicit_euler.h"

#include "sim/methods/parts.h"

namespace sim {

namespace {

/// Adds a force to the accelerations gathered so far.
// Shown lines are short.
// clang-format off
//! [gather]
void gather(
    const Force &force, State &state,
    Points movers, double)
{
    force.add(state, movers, 1.0,
        Directions::apart,
        state.acceleration);
}
//! [gather]
// clang-format on

}

void SemiImplicitEuler::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
}

std::vector<Phase> SemiImplicitEuler::phases(const Scene &scene, double h) const
{
    PhaseList step(scene, directions(), h);
    const Region sum = {"sim/methods/semi_implicit_euler.cpp", "gather"};
    //! [semi_implicit_order]
    // every force sees the same positions
    Share all = step.everything();
    step.forces(all, gather, sum);
    step.kick(all);
    step.damping(all);
    step.move(all);
    step.contacts(all);
    //! [semi_implicit_order]
    std::vector<Phase> phases = step.take();
    if (!phases.empty()) {
        phases.front().run = [first = phases.front().run](State &state) {
            state.acceleration.setZero();
            first(state);
        };
    }
    return phases;
}

}
