#pragma once

#include "sim/methods/implicit/newton.h"
#include "sim/pipeline/method.h"

namespace sim {

/// A method that solves equations for where things will be: what those that do have in common. They differ in which
/// equations. Drivers that act once a step and contacts have phases of their own, round the one that solves.
class ImplicitMethod : public Method
{
public:
    StepLimit stepLimit() const override { return StepLimit::none; }
    int evaluationsPerStep() const override { return 0; }
    std::vector<std::string> requirements() const override { return {"slopes"}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override { return {"sim/methods/implicit/implicit.cpp", "implicit_order"}; }
    void prepareState(State &state) const override;
    /// @throws Error "method-does-not-fit" (method, effect) for a constraint, a drag without a rate and a force without
    /// slopes; "needs-inertia" (method) where points go only where drivers put them
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;

protected:
    /// Takes x and v of a step on by `h` frames.
    using Take = void (*)(ImplicitStep &step, double h);
    virtual Take taking() const = 0;
    /// Where its source stands.
    virtual Region shown() const = 0;

private:
    void checkFit(const Scene &scene) const;
    Phase solving(const Scene &scene, double h) const;
};

}
