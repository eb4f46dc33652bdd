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

/// Adds a torque to the angular accelerations gathered so far.
// Shown lines are short.
// clang-format off
//! [gather_torque]
void gatherTorque(
    const Torque &torque, State &state,
    Points movers, double)
{
    torque.add(state, movers, 1.0,
        state.turning);
}
//! [gather_torque]
// clang-format on

}

void SemiImplicitEuler::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

std::vector<Phase> SemiImplicitEuler::phases(const Scene &scene, StepSize size) const
{
    PhaseList step(scene, directions(), size.h);
    const Adding sum = {gather,
                        gatherTorque,
                        {"sim/methods/semi_implicit_euler.cpp", "gather"},
                        {"sim/methods/semi_implicit_euler.cpp", "gather_torque"}};
    //! [semi_implicit_order]
    // every force sees the same positions
    Share all = step.everything();
    step.driversFirst();
    step.forces(all, sum);
    step.kick(all);
    step.damping(all);
    step.move(all);
    step.constraints(all);
    step.contacts(all);
    step.driversLast();
    //! [semi_implicit_order]
    std::vector<Phase> phases = step.take();
    if (!phases.empty()) {
        phases.front().run = [first = phases.front().run](State &state) {
            state.acceleration.setZero();
            state.turning.setZero();
            first(state);
        };
    }
    return phases;
}

}
