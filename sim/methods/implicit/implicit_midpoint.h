#pragma once

#include "sim/methods/implicit/implicit.h"

namespace sim {

/// The implicit midpoint rule: x += h m, v += h a, with the velocity m and the accelerations a at the middle
/// of the step. Order 2, symplectic and time-reversible without damping. It conserves the energy of a linear
/// spring up to rounding at any step. It does not damp stiff oscillations. Damping is exact: half before and
/// half after (Strang splitting), which keeps the order.
/// Source: Hairer, Lubich and Wanner, "Geometric numerical integration", sections II.1.3 and IV.2.1.
class ImplicitMidpoint : public ImplicitMethod
{
public:
    std::string id() const override { return "implicit_midpoint"; }
    std::string title() const override { return SIM_TEXT("Implicit midpoint"); }
    int order() const override { return 2; }
    Symplectic symplectic() const override { return Symplectic::yes; }

protected:
    StepFunction stepFunction() const override;
    Region stepRegion() const override
    {
        return {"sim/methods/implicit/implicit_midpoint.cpp", "implicit_midpoint"};
    }
};

}
