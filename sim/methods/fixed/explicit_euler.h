#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The explicit (forward) Euler method: x += h v, v += h a(x), both from the values at the start of the step.
/// Order 1. An undamped spring gains energy in every step. Damping multiplies the velocity by damp^h.
/// Source: Hairer, Lubich and Wanner, "Geometric numerical integration", section I.1.2.
class ExplicitEuler : public Method
{
public:
    std::string id() const override { return "explicit_euler"; }
    std::string title() const override { return SIM_TEXT("Explicit Euler"); }
    int order() const override { return 1; }
    std::vector<std::string> requirements() const override { return {}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override
    {
        return {"sim/methods/fixed/explicit_euler.cpp", "explicit_euler_order"};
    }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;
};

}
