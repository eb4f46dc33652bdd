#pragma once

#include "sim/methods/fixed/tableau.h"
#include "sim/pipeline/method.h"

namespace sim {

/// An explicit Runge-Kutta method with fixed steps. It computes the forces at the start, goes to a trial
/// position, computes the forces there, and so on, and then makes the step from all of them. Damping is exact
/// (see StageWeights).
class RungeKutta : public Method
{
public:
    int order() const override { return m_order; }
    int evaluationsPerStep() const override { return m_tableau.stages; }
    std::vector<std::string> requirements() const override { return {}; }
    DirectionRule directionRule() const override { return DirectionRule::regularised; }
    Region region() const override { return {"sim/methods/fixed/runge_kutta.cpp", "runge_kutta_order"}; }
    void prepareState(State &state) const override;
    std::vector<Phase> phases(const Scene &scene, StepSize size) const override;

protected:
    /// `shown`: the source marker of the tableau.
    RungeKutta(const Tableau &tableau, int order, const char *shown)
        : m_tableau(tableau), m_order(order), m_shown(shown)
    {
    }

private:
    Tableau m_tableau;
    int m_order;
    const char *m_shown;
};

/// The explicit midpoint rule. An Euler step finds the middle of the step, and the derivatives there are used
/// for the whole step.
/// Source: Butcher, "Numerical methods for ordinary differential equations", section 232.
class Midpoint : public RungeKutta
{
public:
    Midpoint();
    std::string id() const override { return "midpoint"; }
    std::string title() const override { return SIM_TEXT("Midpoint"); }
};

/// The classical Runge-Kutta method of order 4.
/// Source: Kutta, "Beitrag zur naeherungsweisen Integration totaler Differentialgleichungen", 1901.
class RungeKutta4 : public RungeKutta
{
public:
    RungeKutta4();
    std::string id() const override { return "rk4"; }
    std::string title() const override { return SIM_TEXT("Runge–Kutta 4"); }
};

}
