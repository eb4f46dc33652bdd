#pragma once

#include "sim/forward.h"

#include <optional>

namespace lessons {

struct Look;

/// `scene` with its points where they are in `now`, as wide as `look` draws them. Empty for a scene whose points turn:
/// nothing of it can be built.
std::optional<sim::Taken> blueprintOf(const sim::Scene &scene, const sim::State &now, const Look &look);

}
