#include "sim/methods/fixed/velocity_verlet.h"

#include "sim/methods/zero_accelerations.h"
#include "sim/pipeline/phase_builder.h"

namespace sim {

void VelocityVerlet::prepareState(State &state) const
{
    zeroAccelerations(state);
}

std::vector<Phase> VelocityVerlet::phases(const Scene &scene, StepSize size) const
{
    PhaseBuilder step(scene, directionRule(), size.h);
    //! [velocity_verlet_order]
    // half a kick, move, half a kick
    PhasePoints all = step.allPoints();
    step.leadingImpulses();
    step.accumulateForces(all);
    step.kick(all, 0.5);
    step.damping(all, 0.5);
    step.move(all);
    step.continuousDrivers(1);
    step.accumulateForces(all);
    step.damping(all, 0.5);
    step.kick(all, 0.5);
    step.rewindPrevious(all);
    step.constraints(all);
    step.contacts(all);
    step.trailingImpulses();
    //! [velocity_verlet_order]
    return step.take();
}

}
