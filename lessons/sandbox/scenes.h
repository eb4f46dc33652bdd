#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/values.h"

namespace sandbox::build {

sim::Scene setUp(const sim::Values &values);

}
