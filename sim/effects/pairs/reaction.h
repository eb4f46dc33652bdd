#pragma once

#include "sim/scene/effect.h"

namespace sim {

/// Whether what pulls a point feels that pull itself, turned round.
enum class Reaction {
    none,  ///< it feels nothing
    equal, ///< it feels the opposite, in the same moment
};

/// Newton's third law: the opposite of a pull. Published: Creatures II, step 10.
// The marker leaves out what learners need not read.
// clang-format off
inline
//! [reaction]
Vec2 reaction(Vec2 pull)
{
    // what pulls is pulled back
    Vec2 back = -1 * pull;
    return back;
}
//! [reaction]
// clang-format on

/// Where its source stands.
inline Region reactionRegion()
{
    return {"sim/effects/pairs/reaction.h", "reaction"};
}

}
