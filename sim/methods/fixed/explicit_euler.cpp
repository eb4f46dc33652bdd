#include "sim/methods/fixed/explicit_euler.h"

#include "sim/methods/zero_accelerations.h"
#include "sim/pipeline/phase_builder.h"

namespace sim {

void ExplicitEuler::prepareState(State &state) const
{
    zeroAccelerations(state);
}

std::vector<Phase> ExplicitEuler::phases(const Scene &scene, StepSize size) const
{
    PhaseBuilder step(scene, directionRule(), size.h);
    //! [explicit_euler_order]
    // move by the old velocity
    PhasePoints all = step.allPoints();
    step.leadingImpulses();
    step.accumulateForces(all);
    step.move(all);
    step.continuousDrivers(1);
    step.kick(all);
    step.damping(all);
    step.rewindPrevious(all);
    step.constraints(all);
    step.contacts(all);
    step.trailingImpulses();
    //! [explicit_euler_order]
    return step.take();
}

}
