#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new. Point n is branch n, breadth first, the left child first. Trees are refused as checkGrowth() says.
namespace swaying_tree {

namespace trunk {
sim::Tree grow(const sim::Values &values);
sim::Scene setUp(const sim::Values &values);
}
namespace branches {
sim::Tree grow(const sim::Values &values);
sim::Scene setUp(const sim::Values &values);
}
namespace randomness {
sim::Tree grow(const sim::Values &values);
sim::Scene setUp(const sim::Values &values);
}
namespace towards_pointer {
sim::Scene setUp(const sim::Values &values);
}
namespace wind {
sim::Scene setUp(const sim::Values &values);
}
namespace rest {
sim::Scene setUp(const sim::Values &values);
}
namespace distance {
sim::Scene setUp(const sim::Values &values);
}
namespace thickness {
sim::Scene setUp(const sim::Values &values);
}
namespace turbulence {
sim::Scene setUp(const sim::Values &values);
}
namespace real_sway {
sim::Scene setUp(const sim::Values &values);
}

}
