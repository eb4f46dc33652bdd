#pragma once

#include "app/model/sandbox/blueprint_edits.h"
#include "lessons/api/parameter.h"
#include "sim/effects/all_effects.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace app {

/// A property of the selected parts of a sandbox scene, which a learner can set.
struct SandboxProperty
{
    lessons::Parameter about; ///< its id, name, unit, help and range
    QString section;          ///< the parts that it belongs to: "2 points"
    bool isTruth = false;     ///< either 0 or 1
    /// Returns the value. Empty if the selected parts have different values.
    std::function<std::optional<double>(const sim::Blueprint &, const Selection &)> get;
    std::function<void(sim::Blueprint &, const Selection &, double)> set;
};

/// Returns the properties of the selected points, springs and sticks. A single foot also has those of its leg and its
/// gait group. Points have the properties that the effects of `known` read, for the effects in the plan.
std::vector<SandboxProperty> propertiesOf(const sim::Blueprint &plan, const Selection &chosen,
                                          sim::EffectList known = {});

}
