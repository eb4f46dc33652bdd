#pragma once

#include "sim/base/direction.h"
#include "sim/scene/state.h"

namespace sim {

/// The position at which a force or constraint on the point `mover` would vanish if nothing else moved.
struct RestTarget
{
    int mover = 0;
    int anchor = 0; ///< point at the other end of the spring or stick
    Vec2 position;  ///< px
    /// Whether any position at the same distance from the anchor will do. If false, the mover has to be at
    /// `position`.
    bool isDistance = true;
};

/// Returns the rest target that is `length` px from `anchor` in the direction of `mover`.
inline RestTarget restTargetAt(const State &state, int mover, int anchor, double length)
{
    const Vec2 offset = state.positionOf(mover) - state.positionOf(anchor);
    return {mover, anchor, state.positionOf(anchor) + length * direction(offset, anchor, mover).out};
}

}
