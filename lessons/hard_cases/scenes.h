#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

/// One scene per step (see lessons/README.md). The last step shows the scenes of sim/catalogue.
namespace hard_cases {

/// px, the fixed end of the springs of `limit` and `long_run`.
constexpr sim::Vec2 centre = {270, 200};

namespace limit {
sim::Scene setUp(const sim::Values &values);
}
namespace runaway {
sim::Scene setUp(const sim::Values &values);
}
namespace many_feet {
sim::Scene setUp(const sim::Values &values);
}
namespace one_place {
sim::Scene setUp(const sim::Values &values);
}
namespace stiff {
sim::Scene setUp(const sim::Values &values);
}
namespace contradiction {
sim::Scene setUp(const sim::Values &values);
}
namespace long_run {
sim::Scene setUp(const sim::Values &values);
}
namespace torture {
sim::Scene setUp(const sim::Values &values);
}

}
