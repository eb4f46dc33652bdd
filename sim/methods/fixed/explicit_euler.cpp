#include "sim/methods/fixed/explicit_euler.h"

#include "sim/pipeline/phase_builder.h"

namespace sim {

void ExplicitEuler::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

std::vector<Phase> ExplicitEuler::phases(const Scene &scene, StepSize size) const
{
    PhaseList step(scene, directions(), size.h);
    //! [explicit_euler_order]
    // move by the old velocity
    Share all = step.everything();
    step.jumpsFirst();
    step.gather(all);
    step.move(all);
    step.flow(1);
    step.kick(all);
    step.damping(all);
    step.comeFrom(all);
    step.constraints(all);
    step.contacts(all);
    step.jumpsLast();
    //! [explicit_euler_order]
    return step.take();
}

}
