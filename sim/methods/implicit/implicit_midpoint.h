#pragma once

#include "sim/methods/implicit/implicit.h"

namespace sim {

/// The implicit midpoint rule: x += h m; v += h a, with the velocity m and the pulls a half way between before and
/// after. Order 2; symplectic and the same forwards and backwards where nothing damps: it keeps the energy of a linear
/// spring to rounding at any step. What is stiff it does not damp. Damping enters exactly, half before and half after
/// (Strang's splitting), which keeps the order.
/// Source: Hairer, Lubich and Wanner, "Geometric numerical integration", sections II.1.3 and IV.2.1.
class ImplicitMidpoint : public ImplicitMethod
{
public:
    std::string id() const override { return "implicit_midpoint"; }
    std::string title() const override { return SIM_TEXT("Implicit midpoint"); }
    int order() const override { return 2; }
    Symplectic symplectic() const override { return Symplectic::yes; }

protected:
    Take taking() const override;
    Region shown() const override
    {
        return {"sim/methods/implicit/implicit_midpoint.cpp", "implicit_midpoint"};
    }
};

}
