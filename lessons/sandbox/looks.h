#pragma once

#include "lessons/api/look.h"
#include "sim/scene.h"
#include "sim/values.h"

namespace sandbox {

lessons::Look builtLook(const sim::Scene &scene, const sim::Values &values);

}
