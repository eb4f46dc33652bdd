#pragma once

#include "sim/scene/scene.h"

#include <vector>

namespace sim {

/// Returns the islands of a scene: sets of points that no coupling joins to others, so they can be computed
/// separately. An island is a list of ranges in ascending order. Each point is in exactly one island. Islands
/// are sorted by their lowest point. The whole scene is one island if an active effect depends on more than
/// its couplings.
std::vector<std::vector<PointRange>> islandsOf(const Scene &scene);

}
