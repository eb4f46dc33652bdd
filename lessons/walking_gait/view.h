#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/look.h"

#include <vector>

/// What one sees of the creatures, besides what moves them.
namespace walking_gait {

using Guides = std::vector<lessons::Guide>;

lessons::Look plainLook(const sim::Scene &scene, const sim::Values &values);
lessons::Look straightLegs(const sim::Scene &scene, const sim::Values &values);
lessons::Look curvedLegs(const sim::Scene &scene, const sim::Values &values);
/// The ground, the feet diagram, and a camera that follows the body.
lessons::Look onGround(const sim::Scene &scene, const sim::Values &values);
/// The ground, the feet diagram, and walls on both sides.
lessons::Look inRoom(const sim::Scene &scene, const sim::Values &values);

/// Whether a foot that is not held has the ground under it.
bool stands(const sim::Scene &scene, const sim::State &state, const sim::Values &values, int point);

/// A cross where each foot belongs, and a line to it from the body.
Guides boneLines(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// A cross where each foot belongs.
Guides places(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// The point that bends each leg.
Guides bends(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// A cross where each foot belongs, and the ring on which it goes round.
Guides ring(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// A cross where each foot belongs, and the middle of the creature.
Guides middleAndPlaces(const sim::Scene &scene, const sim::State &state, const sim::Values &values);

}
