#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <QString>

#include <optional>

namespace lessons {

/// Returns the place with this name, px: that of a body of `scene`, “pointer”, “target” in a scene with targets, or “centre”,
/// the fixed end of a spring. Empty if there is none.
std::optional<sim::Vec2> placeNamed(const QString &name, const sim::Scene &scene, const sim::State &state,
                                    const sim::Values &values);

}
