#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <vector>

/// How the scenes of this lesson look, what is drawn over them, and what is measured.
namespace walking_gait {

using Guides = std::vector<lessons::Overlay>;

lessons::View plainLook(const sim::Scene &scene, const sim::Values &values);
lessons::View straightLegs(const sim::Scene &scene, const sim::Values &values);
lessons::View curvedLegs(const sim::Scene &scene, const sim::Values &values);
/// The ground, the feet diagram, and a camera that follows the body.
lessons::View onGround(const sim::Scene &scene, const sim::Values &values);
/// The ground, the feet diagram, and walls on both sides.
lessons::View inRoom(const sim::Scene &scene, const sim::Values &values);

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

/// How far foot 0 is from the middle of its places, px.
lessons::Measure swingWidth();
/// The length of the sum of all velocities, px/frame: the momentum, with masses of 1.
lessons::Measure momentumOfAll();
/// How far the body came to the right in the last frame, px/frame.
lessons::Measure walkingSpeed();
/// How far the feet that stand slid in the last frame, px/frame on the average.
lessons::Measure slip();
/// How fast the gait clock turns, rad/frame.
lessons::Measure clockSpeed();
/// The length of the sum of all pushes between bodies, px/frame^2.
lessons::Measure sumOfPushes();

}
