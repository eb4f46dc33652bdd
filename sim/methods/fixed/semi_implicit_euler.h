#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The semi-implicit (symplectic) Euler method: v += h a(x), then x += h v, for all points at once. Order 1,
/// symplectic without damping. Damping is exact: the factor damp^h on v between the two.
/// Source: Hairer, Lubich and Wanner, "Geometric numerical integration", section I.1.2.
class SemiImplicitEuler : public Method
{
public:
    std::string id() const override { return "semi_implicit_euler"; }
    std::string title() const override { return SIM_TEXT("Semi-implicit Euler"); }
    int order() const override { return 1; }
    Symplectic symplectic() const override { return Symplectic::yes; }
    std::vector<std::string> requirements() const override { return {}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override
    {
        return {"sim/methods/fixed/semi_implicit_euler.cpp", "semi_implicit_order"};
    }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;
};

}
