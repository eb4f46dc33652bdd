#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The position Verlet method: half a move, a kick, half a move. Order 2, symplectic and time-reversible
/// without damping. Damping is exact: the factor of half a step before and after the kick (Strang splitting).
/// Source: Tuckerman, Berne and Martyna, "Reversible multiple time scale molecular dynamics", 1992.
class PositionVerlet : public Method
{
public:
    std::string id() const override { return "position_verlet"; }
    std::string title() const override { return SIM_TEXT("Position Verlet"); }
    int order() const override { return 2; }
    Symplectic symplectic() const override { return Symplectic::yes; }
    std::vector<std::string> requirements() const override { return {}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override
    {
        return {"sim/methods/fixed/position_verlet.cpp", "position_verlet_order"};
    }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;
};

}
