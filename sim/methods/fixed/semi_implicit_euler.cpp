#include "sim/methods/fixed/semi_implicit_euler.h"

#include "sim/pipeline/phase_builder.h"

namespace sim {

void SemiImplicitEuler::prepare(State &state) const
{
    state.acceleration.setZero(state.points(), 2);
    state.turning.setZero(state.spin.rows());
}

std::vector<Phase> SemiImplicitEuler::phases(const Scene &scene, StepSize size) const
{
    PhaseList step(scene, directions(), size.h);
    //! [semi_implicit_order]
    // every force sees the same positions
    Share all = step.everything();
    step.driversFirst();
    step.gather(all);
    step.kick(all);
    step.damping(all);
    step.move(all);
    step.constraints(all);
    step.contacts(all);
    step.driversLast();
    //! [semi_implicit_order]
    return step.take();
}

}
