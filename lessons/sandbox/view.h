#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

namespace sandbox {

/// How a built scene looks: each point as the part that it is, and patches of soft matter.
lessons::View builtLook(const sim::Scene &scene, const sim::Values &values);

}
