#pragma once

#include "sim/base/direction.h"
#include "sim/scene/state.h"
namespace sim {

/// Where a point would be for what holds it to be at rest, as long as everything else stays where it is.
struct RestEnd
{
    int mover = 0;
    int anchor = 0; ///< what it is held to
    Vec2 place;     ///< px
    /// Whether only the distance to the anchor counts, wherever the mover is; else it is this place that does.
    bool isLength = true;
};

/// `length` px from `anchor`, on the side on which `mover` is.
inline RestEnd restAt(const State &state, int mover, int anchor, double length)
{
    const Vec2 from = state.at(mover) - state.at(anchor);
    return {mover, anchor, state.at(anchor) + length * direction(from, anchor, mover).out};
}

}
