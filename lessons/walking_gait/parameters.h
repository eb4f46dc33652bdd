#pragma once

#include "lessons/api/parameter.h"

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
/// `top` and `change`: see sim::Reins.
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

}
