#pragma once

#include "sim/methods/implicit/newton.h"
#include "sim/pipeline/method.h"

namespace sim {

/// The base class of implicit methods, which solve equations for the new positions and velocities. One phase
/// solves, and impulsive drivers and contacts have separate phases before and after it.
class ImplicitMethod : public Method
{
public:
    StepLimit stepLimit() const override { return StepLimit::none; }
    int evaluationsPerStep() const override { return 0; }
    std::vector<std::string> requirements() const override { return {"jacobian"}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override { return {"sim/methods/implicit/implicit.cpp", "implicit_order"}; }
    void prepareState(State &state) const override;
    /// @throws Error "method-does-not-fit" (method, effect) for a constraint, a drag without a rate or a
    /// force without a Jacobian; "needs-inertia" (method) for points with prescribed motion
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;

protected:
    /// Advances x and v of a step by `h` frames.
    using StepFunction = void (*)(ImplicitStep &step, double h);
    virtual StepFunction stepFunction() const = 0;
    /// Returns the source region of the step function.
    virtual Region stepRegion() const = 0;

private:
    void checkFit(const Scene &scene) const;
    /// Returns the phase that computes forces, damping and motion by solving equations.
    Phase solvePhase(const Scene &scene, double h) const;
};

}
