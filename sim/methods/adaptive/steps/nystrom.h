#pragma once

#include "sim/methods/adaptive/adaptive.h"
#include "sim/methods/adaptive/steps/step_rule.h"

namespace sim {

/// Runge-Kutta-Nystrom methods solve q'' = a(q) itself: their stages are places only, so they need fewer than others.
/// This one is of order 8, measured by one of order 6 on the same stages; the last stage stands at the end of the step.
/// Source: Dormand, El-Mikkawy and Prince, "High-order embedded Runge-Kutta-Nystrom formulae", 1987.
struct NystromTableau
{
    static constexpr int stages = 9;
    using Row = std::array<double, stages>;

    Row c{};                        ///< where each stage is, as a share of the step
    std::array<Row, stages> a{};    ///< the place of each stage; the last row is that of the end
    Row b{};                        ///< the velocity at the end
    Row lowerPlace{}, lowerSpeed{}; ///< place and velocity of order 6
};

/// Damping enters exactly, by the clock: as long as nothing pulls, a damped point goes the way s = (1 - e^(-c t)) / c
/// times its first velocity. In s for a time the equation q'' = a(q, t) - c q' becomes d2q/ds2 = e^(2 c t) a(q, t),
/// without a velocity. These are the weights of a step of h frames for the accelerations a, that factor included.
struct NystromWeights
{
    static constexpr int stages = NystromTableau::stages;
    using Row = std::array<double, stages + 1>;

    /// The first is that of the velocity at the start, the others those of the stages so far.
    std::array<Row, stages> place{};
    Row speed{};
    NystromTableau::Row placeOff{}, speedOff{}; ///< the difference to order 6
    double whole = 0.0;                         ///< s at the end, frames
    double rate = -1.0;                         ///< what the weights are for
    double h = 0.0;

    /// Asked for the same again, it leaves them.
    void set(const NystromTableau &of, double c, double step);
};

/// Steps of that method. All that moves by itself must be slowed at the same rate.
class RungeKuttaNystrom : public StepRule
{
public:
    RungeKuttaNystrom();

    int order() const override { return 8; }
    int errorOrder() const override { return 7; }
    /// A place, the velocity at the start, the acceleration of each stage, and that in the middle.
    int scratchColumns() const override { return 3 + NystromTableau::stages; }
    int denseColumns() const override { return 7; }
    std::vector<std::string> requirements() const override { return {"one_damping"}; }
    bool fits(const OdeSystem &system) const override { return system.uniformRate().has_value(); }
    double attempt(const StepAttempt &step) const override;
    void makeDense(const StepAttempt &step) const override;
    DenseTime instant(double rate, double h, double theta) const override;
    void dense(const double *columns, int size, int first, int end, const DenseTime &when, double *place,
               double *speed) const override;

private:
    NystromTableau m_tableau;
};

/// The method: damping exact, contacts located in time, between steps a polynomial that gives every frame.
class Nystrom : public Adaptive
{
public:
    Nystrom();
    std::string id() const override { return "rkn86"; }
    std::string title() const override { return SIM_TEXT("Runge–Kutta–Nyström 8(6)"); }
};

}
