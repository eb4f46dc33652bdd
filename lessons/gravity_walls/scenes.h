#pragma once

#include "sim/forward.h"

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new. The feet are points 0, 1, 2..., the body comes last.
namespace gravity_walls {

namespace walls {
sim::Scene setUp(const sim::Values &values);
}
namespace gravity {
sim::Scene setUp(const sim::Values &values);
}

}
