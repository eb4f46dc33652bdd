#pragma once

#include "sim/forward.h"

/// One scene per step (see lessons/README.md). Point 0 is the foot. Point 1 is the body, if there is one.
namespace single_spring {

constexpr int foot = 0;
constexpr int body = 1;

namespace drag {
sim::Scene setUp(const sim::Values &values);
}
namespace fixed_centre {
sim::Scene setUp(const sim::Values &values);
}
namespace moving_body {
sim::Scene setUp(const sim::Values &values);
}
namespace offset {
sim::Scene setUp(const sim::Values &values);
}
namespace radial {
sim::Scene setUp(const sim::Values &values);
}

}
