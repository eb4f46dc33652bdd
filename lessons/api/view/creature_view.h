#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

#include <vector>

namespace lessons {

/// Feet and bodies as discs; with legs, a line from the body to each of its feet.
View creatureView(const sim::Scene &scene);
View creatureViewWithLegs(const sim::Scene &scene);
/// The same, with legs, for a scene of crowdByParts().
View crowdByPartsView(const sim::Scene &scene, int creatures);
/// Returns one zigzag for each spring that acts in `scene`: none where its stiffness is 0 or it is switched off, and
/// one where two points pull each other. Legs that a gait turns have none, as their places move by themselves.
std::vector<SpringView> actingSprings(const sim::Scene &scene);

}
