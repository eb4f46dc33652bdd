#pragma once

#include "sim/forward.h"
#include "sim/scene/effect.h"
#include "sim/scene/state.h"

#include <memory>
#include <string>
#include <vector>

namespace sim {

/// How the points of a group move.
enum class Motion {
    byVelocity, ///< they have a velocity (or spin) and move by it
    prescribed, ///< only drivers and constraints move them
};

/// Points that a sequential method (`published`) moves together, before it computes the next group.
struct Group
{
    std::string title; ///< in English; see SIM_TEXT
    PointRange points;
    Motion motion = Motion::byVelocity;
};

/// A simulation: its initial state, its effects, and the update order of its points.
struct Scene
{
    State start;                    ///< the initial state
    std::vector<std::string> names; ///< per point: the name that files and events use
    std::vector<Group> groups;      ///< in update order; every point that can move is in one
    std::vector<EffectPtr> effects; ///< in the order in which they act
    /// The parameters from which it was built, for methods that read them by name. sceneOf() sets it; null for
    /// a scene that was built directly.
    std::shared_ptr<const Values> values = {};

    /// Returns the index of the point called `name`, or -1.
    int find(const std::string &name) const;
    /// Returns whether `point` is in a group that moves by its velocity. (A point in no group is a handle.)
    bool movesByVelocity(int point) const;
};

}
