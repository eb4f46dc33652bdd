#pragma once

#include "sim/base/direction.h"
#include "sim/scene/state.h"
namespace sim {

/// Where a point would be for what holds it to be at rest, as long as everything else stays where it is.
struct RestTarget
{
    int mover = 0;
    int anchor = 0; ///< what it is held to
    Vec2 position;  ///< px
    /// Whether only the distance to the anchor counts, wherever the mover is; else it is this place that does.
    bool isDistance = true;
};

/// `length` px from `anchor`, on the side on which `mover` is.
inline RestTarget restTargetAt(const State &state, int mover, int anchor, double length)
{
    const Vec2 from = state.positionOf(mover) - state.positionOf(anchor);
    return {mover, anchor, state.positionOf(anchor) + length * direction(from, anchor, mover).out};
}

}
