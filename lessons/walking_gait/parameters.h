#pragma once

#include "lessons/api/step.h"

#include <vector>

/// The parameters of this lesson, and values of them that go well together.
namespace walking_gait {

lessons::Parameter leg();
lessons::Parameter drop();
lessons::Parameter curve();
lessons::Parameter speed();
/// `bounce`, of feet on the ground.
lessons::Parameter footBounce();
/// `traction`: full or none; in the order of sim::Traction.
lessons::Parameter traction();
/// `feet` and `spread`.
lessons::Parameter legCount();
lessons::Parameter spread();
/// `top` and `change`: see sim::SteeringLimits.
lessons::Parameter top();
lessons::Parameter change();
/// `at_wall`: turn or keep_on.
lessons::Parameter atWall();
lessons::Parameter creatures();
/// `push` and `distance`: see sim::Push.
lessons::Parameter push();
lessons::Parameter distance();
/// `felt_by`: both or one; who feels a push.
lessons::Parameter feltBy();
/// `left` and `right`: those of room(), without the floor.
std::vector<lessons::Parameter> sideWalls();

/// Ways to walk, by the values that make them.
std::vector<lessons::Preset> gaits();

}
