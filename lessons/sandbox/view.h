#pragma once

#include "lessons/api/view/view.h"
#include "sim/forward.h"

namespace sandbox {

/// Returns a view of a built scene. The shape of a point depends on whether sticks or feet use it. Four
/// springs with crossing diagonals are drawn as a soft sheet.
lessons::View sandboxView(const sim::Scene &scene, const sim::Values &values);

}
