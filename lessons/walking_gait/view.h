#pragma once

#include "lessons/api/step.h"
#include "lessons/api/view/view.h"

#include <vector>

/// The views, overlays and measures of this lesson.
namespace walking_gait {

using Overlays = std::vector<lessons::Overlay>;

/// Returns a view of discs and of the springs that act, with the angle of the first bone, from its foot to the body.
lessons::View bonesView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view with straight legs.
lessons::View straightLegsView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view with legs that are bent by the parameter `curve`.
lessons::View curvedLegsView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view with the ground, the feet diagram, and a camera that follows the body.
lessons::View groundView(const sim::Scene &scene, const sim::Values &values);
/// Returns a view with the ground, the feet diagram, and walls on both sides.
lessons::View roomView(const sim::Scene &scene, const sim::Values &values);

/// Returns whether `point` is a planted foot: dynamic, and at or below the ground.
bool isPlanted(const sim::Scene &scene, const sim::State &state, const sim::Values &values, int point);

/// Returns a cross at the target of each foot, and a line to it from the body.
Overlays boneLines(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// Returns a cross at the target of each foot.
Overlays footTargets(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// Returns the control point of each leg's curve, with lines to foot and body.
Overlays legControlPoints(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// Returns a cross at the target of each foot, and the circle on which the targets move.
Overlays targetsOnCircle(const sim::Scene &scene, const sim::State &state, const sim::Values &values);
/// Returns a cross at the target of each foot, and one at the centre of all points.
Overlays centreAndTargets(const sim::Scene &scene, const sim::State &state, const sim::Values &values);

/// Returns the distance of foot 0 from the centre of the circle on which its target moves, px.
lessons::Measure swingWidth();
/// Returns the magnitude of the momentum, px/frame for masses of 1.
lessons::Measure momentumOfAll();
/// Returns how far the body moved to the right in the last frame, px/frame.
lessons::Measure walkingSpeed();
/// Returns the average distance that planted feet slid in the last frame, px/frame.
lessons::Measure slip();
/// Returns the speed of the gait clock, rad/frame.
lessons::Measure clockSpeed();
/// Returns the magnitude of the sum of all pushes between bodies, px/frame^2.
lessons::Measure sumOfPushes();

}
