#pragma once

#include "sim/scene/scene.h"

#include <vector>

namespace sim {

/// The parts of a scene that nothing ties to each other: what happens in one changes nothing in the others. Each is
/// a list of runs of neighbouring points in ascending order; together they hold every point once, and the one with the
/// lowest point comes first. One part where an effect that acts sees more than what it ties.
std::vector<std::vector<PointRange>> islandsOf(const Scene &scene);

}
