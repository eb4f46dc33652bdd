#pragma once

#include "sim/methods/adaptive/adaptive.h"
#include "sim/methods/adaptive/steps/step_rule.h"

namespace sim {

/// The coefficients of a Runge-Kutta-Nystrom method. Such methods solve q'' = a(q) directly. Their stages are
/// positions only, so they need fewer stages than others. This method has order 8, and one of order 6 on the
/// same stages estimates its error. The last stage is at the end of the step.
/// Source: Dormand, El-Mikkawy and Prince, "High-order embedded Runge-Kutta-Nystrom formulae", 1987.
struct NystromTableau
{
    static constexpr int stages = 9;
    using Row = std::array<double, stages>;

    Row c{};                     ///< time of each stage, as a share of the step
    std::array<Row, stages> a{}; ///< weights for the position of each stage; last row: end of the step
    Row b{};                     ///< weights for the velocity at the end
    Row lowerPosition{}, lowerVelocity{}; ///< weights of order 6 for the position and velocity at the end
};

/// The weights of a step of h frames for the accelerations a of its stages. Damping at a rate c is exact: the
/// method uses s = (1 - e^(-c t)) / c instead of the time. Without forces, a point moves by s times its
/// initial velocity. In s, the equation q'' = a(q, t) - c q' becomes d2q/ds2 = e^(2 c t) a(q, t), without a
/// velocity. The weights include that factor.
struct NystromWeights
{
    static constexpr int stages = NystromTableau::stages;
    using Row = std::array<double, stages + 1>;

    /// For the position of each stage: first the weight of the initial velocity, then those of the earlier
    /// stages.
    std::array<Row, stages> position{};
    Row velocity{};                                       ///< likewise, for the velocity at the end
    NystromTableau::Row positionError{}, velocityError{}; ///< differences to order 6
    double whole = 0.0;                                   ///< frames, s at the end of the step
    double rate = -1.0;                                   ///< 1/frame, damping rate c of the last set()
    double h = 0.0;                                       ///< frames, length of the step of the last set()

    /// Computes the weights for a damping rate c and a step of `step` frames. Does nothing if both are the
    /// same as last time.
    void set(const NystromTableau &coefficients, double c, double step);
};

/// The step rule of that method. It needs the same damping rate for all points that move by their velocities.
class RungeKuttaNystrom : public StepRule
{
public:
    RungeKuttaNystrom();

    int order() const override { return 8; }
    int errorOrder() const override { return 7; }
    /// One column for errors and positions, one for the initial velocity, one per stage for accelerations,
    /// and one for the acceleration in the middle of the step.
    int scratchColumns() const override { return 3 + NystromTableau::stages; }
    int denseColumns() const override { return 7; }
    std::vector<std::string> requirements() const override { return {"one_damping"}; }
    bool fits(const OdeSystem &system) const override
    {
        return system.uniformRate().has_value() && !system.readsVelocities();
    }
    double attempt(const StepAttempt &step) const override;
    void makeDense(const StepAttempt &step) const override;
    DenseTime instant(double rate, double h, double theta) const override;
    void dense(const double *columns, int size, int first, int end, const DenseTime &time, double *x,
               double *v) const override;

private:
    NystromTableau m_tableau;
};

/// The adaptive method with that step rule. Damping is exact, contact events are located in time, and dense
/// output gives every frame.
class Nystrom : public Adaptive
{
public:
    Nystrom();
    std::string id() const override { return "rkn86"; }
    std::string title() const override { return SIM_TEXT("Runge–Kutta–Nyström 8(6)"); }
};

}
