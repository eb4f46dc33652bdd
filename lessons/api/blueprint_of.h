#pragma once

#include "sim/forward.h"

#include <optional>

namespace lessons {

struct View;

/// `scene` with its points where they are in `now`, as wide as `look` draws them. Empty for a scene whose points turn:
/// nothing of it can be built.
std::optional<sim::BlueprintDraft> blueprintOf(const sim::Scene &scene, const sim::State &now,
                                               const View &look);

}
