#pragma once

#include "sim/forward.h"

#include <optional>

namespace lessons {

struct View;

/// Returns the sandbox draft of `scene` with its points where they are in `state` and as wide as `view` draws
/// them. Empty for a scene whose points have angles, because the sandbox cannot build them.
std::optional<sim::BlueprintDraft> blueprintOf(const sim::Scene &scene, const sim::State &state,
                                               const View &view);

}
