#pragma once

#include "sim/scene/scene.h"
#include "sim/scene/values.h"

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new.
namespace codeling {

namespace motor {
sim::Scene setUp(const sim::Values &values);
}
namespace orientation {
sim::Scene setUp(const sim::Values &values);
}
namespace anticipation {
sim::Scene setUp(const sim::Values &values);
}
namespace squash_stretch {
sim::Scene setUp(const sim::Values &values);
}
namespace volume {
sim::Scene setUp(const sim::Values &values);
}
namespace tentacles {
sim::Scene setUp(const sim::Values &values);
}

}
