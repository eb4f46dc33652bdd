#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The velocity Verlet method: half a kick, a move, half a kick. Order 2, symplectic and time-reversible
/// without damping. Damping is exact: the factor of half a step before and after the move (Strang splitting).
/// Forces are computed before and after the move, because input or contacts may have moved points since the
/// last step.
/// Source: Swope, Andersen, Berens and Wilson, 1982; Hairer, Lubich and Wanner, section I.1.4.
class VelocityVerlet : public Method
{
public:
    std::string id() const override { return "velocity_verlet"; }
    std::string title() const override { return SIM_TEXT("Velocity Verlet"); }
    int order() const override { return 2; }
    Symplectic symplectic() const override { return Symplectic::yes; }
    int evaluationsPerStep() const override { return 2; }
    std::vector<std::string> requirements() const override { return {}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override
    {
        return {"sim/methods/fixed/velocity_verlet.cpp", "velocity_verlet_order"};
    }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;
};

}
