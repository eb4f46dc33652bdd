#pragma once

#include "sim/scene.h"
#include "sim/values.h"

namespace sandbox::build {

sim::Scene setUp(const sim::Values &values);

}
