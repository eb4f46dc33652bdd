#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/values.h"

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new. A file's points and sticks take the place of the step's own.
namespace rigid_constraint {

namespace pair {
sim::Scene setUp(const sim::Values &values);
}
namespace shared_error {
sim::Scene setUp(const sim::Values &values);
}
namespace triangle {
sim::Scene setUp(const sim::Values &values);
}
namespace list {
sim::Scene setUp(const sim::Values &values);
}
namespace verlet {
sim::Scene setUp(const sim::Values &values);
}
namespace ragdoll {
sim::Scene setUp(const sim::Values &values);
}

}
