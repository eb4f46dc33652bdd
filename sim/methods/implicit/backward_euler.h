#pragma once

#include "sim/methods/implicit/implicit.h"

namespace sim {

/// Backward (implicit) Euler: v = damp^h (v + h a(x)); x += h v, with the pulls from where x comes to. Order 1. Stays
/// bounded at any step and stiffness, and damps what swings faster than the step follows, stiff or not.
/// Source: Hairer and Wanner, "Solving ordinary differential equations II", section IV.3; in animation: Baraff and
/// Witkin, "Large steps in cloth simulation", 1998.
class BackwardEuler : public ImplicitMethod
{
public:
    std::string id() const override { return "backward_euler"; }
    std::string title() const override { return SIM_TEXT("Backward Euler"); }
    int order() const override { return 1; }

protected:
    Take taking() const override;
    Region shown() const override { return {"sim/methods/implicit/backward_euler.cpp", "backward_euler"}; }
};

}
