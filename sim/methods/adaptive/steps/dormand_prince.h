#pragma once

#include "sim/methods/adaptive/adaptive.h"

namespace sim {

/// The method of Dormand and Prince of order 5. A method of order 4 on the same stages estimates its error.
/// Damping is exact, contact events are located in time, and dense output gives every frame. See
/// dormandPrincePair().
class DormandPrince : public Adaptive
{
public:
    DormandPrince();
    std::string id() const override { return "dormand_prince"; }
    std::string title() const override { return SIM_TEXT("Dormand–Prince 5(4)"); }
};

}
