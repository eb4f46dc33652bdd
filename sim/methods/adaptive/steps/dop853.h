#pragma once

#include "sim/methods/adaptive/adaptive.h"

namespace sim {

/// The method of order 8 of Hairer and Wanner's program DOP853. Methods of orders 5 and 3 on the same stages
/// estimate its error. Damping is exact, contact events are located in time, and dense output gives every
/// frame. See dop853Pair().
class Dop853 : public Adaptive
{
public:
    Dop853();
    std::string id() const override { return "dop853"; }
    std::string title() const override { return SIM_TEXT("Dormand–Prince 8(5,3)"); }
};

}
