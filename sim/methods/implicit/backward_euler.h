#pragma once

#include "sim/methods/implicit/implicit.h"

namespace sim {

/// The backward (implicit) Euler method: v = damp^h (v + h a(x)), x += h v, with the accelerations at the new
/// x. Order 1. It stays bounded at any step and stiffness. It damps every oscillation that is too fast for
/// the step.
/// Source: Hairer and Wanner, "Solving ordinary differential equations II", section IV.3; in animation:
/// Baraff and Witkin, "Large steps in cloth simulation", 1998.
class BackwardEuler : public ImplicitMethod
{
public:
    std::string id() const override { return "backward_euler"; }
    std::string title() const override { return SIM_TEXT("Backward Euler"); }
    int order() const override { return 1; }

protected:
    StepFunction stepFunction() const override;
    Region stepRegion() const override
    {
        return {"sim/methods/implicit/backward_euler.cpp", "backward_euler"};
    }
};

}
