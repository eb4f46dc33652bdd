#include "sim/methods/fixed/position_verlet.h"

#include "sim/methods/zero_accelerations.h"
#include "sim/pipeline/phase_builder.h"

namespace sim {

void PositionVerlet::prepareState(State &state) const
{
    zeroAccelerations(state);
}

std::vector<Phase> PositionVerlet::phases(const Scene &scene, StepSize size) const
{
    PhaseBuilder step(scene, directionRule(), size.h);
    //! [position_verlet_order]
    // half a move, kick, half a move
    PhasePoints all = step.allPoints();
    step.leadingImpulses();
    step.move(all, 0.5);
    step.continuousDrivers(0.5);
    step.damping(all, 0.5);
    step.accumulateForces(all);
    step.kick(all);
    step.damping(all, 0.5);
    step.move(all, 0.5);
    step.continuousDrivers(0.5);
    step.rewindPrevious(all);
    step.constraints(all);
    step.contacts(all);
    step.trailingImpulses();
    //! [position_verlet_order]
    return step.take();
}

}
