#pragma once

#include "lessons/api/look.h"
#include "sim/blueprint.h"
#include "sim/scene.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lessons {

/// A scene as somebody could have built it.
struct Taken
{
    sim::Blueprint blueprint;
    std::map<std::string, double> numbers; ///< parameters of a workshop that follow from its effects, by id
    std::vector<std::string> left;         ///< what of it nobody can build, in English; see SIM_TEXT
};

/// `scene` with its points where they are in `now`, as wide as `look` draws them. Empty for a scene whose points turn:
/// nothing of it can be built.
std::optional<Taken> blueprintOf(const sim::Scene &scene, const sim::State &now, const Look &look);

}
