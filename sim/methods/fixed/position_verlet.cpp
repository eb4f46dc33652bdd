#include "sim/methods/fixed/position_verlet.h"

#include "sim/pipeline/phase_builder.h"

namespace sim {

void PositionVerlet::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

std::vector<Phase> PositionVerlet::phases(const Scene &scene, StepSize size) const
{
    PhaseList step(scene, directions(), size.h);
    //! [position_verlet_order]
    // half a move, kick, half a move
    Share all = step.everything();
    step.jumpsFirst();
    step.move(all, 0.5);
    step.flow(0.5);
    step.damping(all, 0.5);
    step.gather(all);
    step.kick(all);
    step.damping(all, 0.5);
    step.move(all, 0.5);
    step.flow(0.5);
    step.comeFrom(all);
    step.constraints(all);
    step.contacts(all);
    step.jumpsLast();
    //! [position_verlet_order]
    return step.take();
}

}
