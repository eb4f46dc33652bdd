#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The effect that made a number of a point non-finite.
struct FailureCause
{
    EffectPtr effect; ///< null if no effect acts on the point
    /// The point at the other end of the force; -1: it has no other end, or the effect is not a force.
    int other = -1;
};

/// Returns the effect that produced the first non-finite value in `phase`, at `point` (-1: the value belongs
/// to no point). If the phase belongs to the method and not to an effect, returns the strongest force on the
/// point. `before`: the state before the phase.
FailureCause failureCauseOf(const Phase &phase, const Scene &scene, const State &before, int point,
                            DirectionRule directionRule);

}
