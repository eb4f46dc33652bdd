#pragma once

#include "sim/forward.h"

/// One scene per step (see lessons/README.md). The feet are points 0, 1, 2... and the body is the last point.
namespace multi_foot {

namespace two_feet {
sim::Scene setUp(const sim::Values &values);
}
namespace any_number {
sim::Scene setUp(const sim::Values &values);
}
namespace grown_feet {
sim::Scene setUp(const sim::Values &values);
}

}
