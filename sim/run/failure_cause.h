#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// What made a point fail.
struct FailureCause
{
    EffectPtr effect; ///< null where nothing acts on the point
    int other = -1;   ///< the point at the other end of the pull; -1: it pulls to a place, or it is no pull
};

/// Whose doing it is that `phase` failed at `point` (-1: at what belongs to no point), coming from `before`: the effect
/// whose phase it is, and in a phase of the method's own what pulls the point hardest.
FailureCause failureCauseOf(const Phase &phase, const Scene &scene, const State &before, int point,
                            DirectionRule directionRule);

}
