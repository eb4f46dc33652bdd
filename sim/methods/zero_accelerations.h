#pragma once

#include "sim/scene/state.h"

namespace sim {

/// Gives `state` the columns of accelerations, all 0.
inline void zeroAccelerations(State &state)
{
    state.acceleration.setZero(state.pointCount(), 2);
    state.angularAcceleration.setZero(state.spin.rows());
}

}
