#pragma once

#include "sim/scene/effect.h"

namespace sim {

/// Whether the point that pulls another one feels the opposite pull.
enum class Reaction {
    none,  ///< it does not
    equal, ///< it feels exactly the opposite pull at the same time
};

/// Returns the opposite of `pull` (mass px/frame^2): Newton's third law. Published: Creatures II, step 10.
// The marker leaves out `inline`, which learners need not read.
// clang-format off
inline
//! [reaction]
Vec2 reaction(Vec2 pull)
{
    // the other end is pulled back
    Vec2 back = -1 * pull;
    return back;
}
//! [reaction]
// clang-format on

/// Returns the region with the source code of reaction().
inline Region reactionRegion()
{
    return {"sim/effects/pairs/reaction.h", "reaction"};
}

}
