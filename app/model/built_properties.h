#pragma once

#include "app/model/blueprint_edits.h"
#include "lessons/api/parameter.h"
#include "sim/effects/all_effects.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace app {

/// A number of what is chosen in a built scene, that a learner can set.
struct BuiltProperty
{
    lessons::Parameter about; ///< its id, name, unit, help and range
    QString section;          ///< what it belongs to: "2 points"
    bool isTruth = false;     ///< 0 or 1, and nothing between
    /// Its value; empty where the chosen parts do not have the same.
    std::function<std::optional<double>(const sim::Blueprint &, const Chosen &)> get;
    std::function<void(sim::Blueprint &, const Chosen &, double)> set;
};

/// What can be set of the chosen parts: of points, springs and sticks; of a single foot its leg and its gait group, too.
/// Points have what those effects of `known` read of them that the plan lists.
std::vector<BuiltProperty> propertiesOf(const sim::Blueprint &plan, const Chosen &chosen,
                                        sim::EffectList known = {});

}
