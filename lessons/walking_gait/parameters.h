#pragma once

#include "lessons/api/step.h"

#include <vector>

/// The parameters and presets of this lesson.
namespace walking_gait {

lessons::Parameter leg();
lessons::Parameter drop();
lessons::Parameter curve();
lessons::Parameter speed();
/// Returns `bounce` for feet on the ground.
lessons::Parameter footBounce();
/// Returns `traction`, a choice of full or none, in the order of sim::Traction.
lessons::Parameter traction();
/// Returns `feet`, the number of legs.
lessons::Parameter legCount();
/// Returns `spread`, the angle over which the feet are spread.
lessons::Parameter spread();
/// Returns `top` of sim::SteeringLimits.
lessons::Parameter top();
/// Returns `change` of sim::SteeringLimits.
lessons::Parameter change();
/// Returns `at_wall`, a choice of turn or keep_on.
lessons::Parameter atWall();
lessons::Parameter creatures();
/// Returns `push`, the stiffness of sim::Push.
lessons::Parameter push();
/// Returns `distance`, the range of sim::Push.
lessons::Parameter distance();
/// Returns `felt_by`, a choice of both or one: the bodies that feel a push.
lessons::Parameter feltBy();
/// Returns `left` and `right` of room(), without the floor.
std::vector<lessons::Parameter> sideWalls();

/// Returns presets of different gaits.
std::vector<lessons::Preset> gaits();

}
