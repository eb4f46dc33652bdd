#include "sim/methods/fixed/semi_implicit_euler.h"

#include "sim/methods/zero_accelerations.h"
#include "sim/pipeline/phase_builder.h"

namespace sim {

void SemiImplicitEuler::prepareState(State &state) const
{
    zeroAccelerations(state);
}

std::vector<Phase> SemiImplicitEuler::phases(const Scene &scene, StepSize size) const
{
    PhaseBuilder step(scene, directionRule(), size.h);
    //! [semi_implicit_order]
    // every force sees the same positions
    PhasePoints all = step.allPoints();
    step.leadingDrivers();
    step.accumulateForces(all);
    step.kick(all);
    step.damping(all);
    step.move(all);
    step.constraints(all);
    step.contacts(all);
    step.trailingDrivers();
    //! [semi_implicit_order]
    return step.take();
}

}
