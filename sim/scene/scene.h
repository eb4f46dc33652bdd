#pragma once

#include "sim/scene/effect.h"
#include "sim/scene/state.h"

#include <string>
#include <vector>

namespace sim {

/// Whether points go on by themselves.
enum class Motion {
    byVelocity, ///< they have a velocity (or spin), and move by it
    prescribed, ///< they go only where drivers and constraints put them
};

/// Points that a sequential method (`published`) moves together, before the next group sees them.
struct Group
{
    std::string title; ///< in English; see SIM_TEXT
    PointRange points;
    Motion motion = Motion::byVelocity;
};

/// What is simulated: a start, the effects that act (no others are computed), and the published update order.
struct Scene
{
    State start;
    std::vector<std::string> names; ///< one a point; how files and events call it
    std::vector<Group> groups;      ///< in update order; together they hold every point that can move
    std::vector<EffectPtr> effects; ///< in the order in which they act

    /// The number of the point called `name`, or -1.
    int find(const std::string &name) const;
    /// Whether `point` is in a group that goes on by itself. (What is in no group is a handle.)
    bool movesByVelocity(int point) const;
};

}
