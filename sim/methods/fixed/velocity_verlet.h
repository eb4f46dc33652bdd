#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// Velocity Verlet: half a kick, a whole move, half a kick. Order 2; symplectic without damping, and the same
/// backwards. Damping enters exactly, by half a step's factor on either side of the move (Strang splitting). Forces
/// are computed before and after the move: something else may have moved what the step before left.
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
