#pragma once

#include "sim/forward.h"

/// One scene per step (see lessons/README.md). The feet are points 0, 1, 2... and the body is the last point.
namespace gravity_walls {

namespace walls {
sim::Scene setUp(const sim::Values &values);
}
namespace gravity {
sim::Scene setUp(const sim::Values &values);
}

}
