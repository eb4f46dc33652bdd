#pragma once

#include "sim/methods/adaptive/adaptive.h"

namespace sim {

/// Dormand and Prince's method: order 5, with steps that a method of order 4 on the same stages measures. Damping is
/// exact; contacts are located in time; between steps a polynomial gives every frame. See dormandPrincePair().
class DormandPrince : public Adaptive
{
public:
    DormandPrince();
    std::string id() const override { return "dormand_prince"; }
    std::string title() const override { return SIM_TEXT("Dormand–Prince 5(4)"); }
};

}
