#include "sim/methods/fixed/velocity_verlet.h"

#include "sim/pipeline/phase_builder.h"

namespace sim {

void VelocityVerlet::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

std::vector<Phase> VelocityVerlet::phases(const Scene &scene, StepSize size) const
{
    PhaseList step(scene, directions(), size.h);
    //! [velocity_verlet_order]
    // half a kick, move, half a kick
    Share all = step.everything();
    step.jumpsFirst();
    step.gather(all);
    step.kick(all, 0.5);
    step.damping(all, 0.5);
    step.move(all);
    step.flow(1);
    step.gather(all);
    step.damping(all, 0.5);
    step.kick(all, 0.5);
    step.comeFrom(all);
    step.constraints(all);
    step.contacts(all);
    step.jumpsLast();
    //! [velocity_verlet_order]
    return step.take();
}

}
