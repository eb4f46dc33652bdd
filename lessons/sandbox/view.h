#pragma once

#include "lessons/api/view/look.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

namespace sandbox {

lessons::Look builtLook(const sim::Scene &scene, const sim::Values &values);

}
