#pragma once

#include "sim/forward.h"

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new. Point 0 is the foot; where there is a body it is point 1.
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
