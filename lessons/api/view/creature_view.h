#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

namespace lessons {

/// Returns a view of feet and bodies as discs.
View creatureView(const sim::Scene &scene);
/// Returns the same view with a line from each body to each of its feet.
View creatureViewWithLegs(const sim::Scene &scene);
/// Returns a view with legs of a scene of crowdByParts().
View crowdByPartsView(const sim::Scene &scene, int creatures);
/// Returns one zigzag for each spring that acts in `scene`. Springs of stiffness 0 have none, and two points
/// that pull each other have one. Legs that a gait clock turns have none, because their target moves.
std::vector<SpringView> actingSprings(const sim::Scene &scene);

}
