#pragma once

#include "lessons/api/look.h"
#include "sim/scenes/creatures.h"

#include <vector>

/// How creatures look. The creatures themselves come from sim/scenes, and lessons call them without its name.
namespace lessons {

using scenes::add;
using scenes::bodyWidth;
using scenes::creature;
using scenes::creatureOnHandle;
using scenes::crowd;
using scenes::crowdByParts;
using scenes::footWidth;
using scenes::halfWidths;
using scenes::isBody;
using scenes::loneFoot;
using scenes::pair;
using scenes::pairOnHandle;
using scenes::placeFeet;

/// Feet and bodies as discs; with legs, a line from the body to each of its feet.
Look creatureLook(const sim::Scene &scene);
Look creatureLookWithLegs(const sim::Scene &scene);
/// Returns one zigzag for each spring that acts in `scene`: none where its stiffness is 0 or it is switched off, and
/// one where two points pull each other. Legs that a gait turns have none, as their places move by themselves.
std::vector<SpringLook> actingSprings(const sim::Scene &scene);
/// The same, with legs, for a scene of crowdByParts().
Look crowdByPartsLook(const sim::Scene &scene, int creatures);

}
