#pragma once

#include "sim/methods/adaptive/steps/embedded_pair.h"
#include "sim/methods/adaptive/steps/step_rule.h"

namespace sim {

/// The step rule of an embedded pair of explicit Runge-Kutta methods. Damping is exact, also if rows have
/// different rates (see StageWeights).
class EmbeddedRungeKutta : public StepRule
{
public:
    explicit EmbeddedRungeKutta(const EmbeddedPair &pair) : m_pair(pair) {}

    int order() const override { return m_pair.order(); }
    /// One column for an error estimate, one for positions, and two per stage for velocities and
    /// accelerations.
    int scratchColumns() const override { return 2 + 2 * stages(); }
    int denseColumns() const override { return m_pair.denseColumns(); }
    double attempt(const StepAttempt &step) const override;
    void makeDense(const StepAttempt &step) const override;
    DenseTime instant(double rate, double h, double theta) const override;
    void dense(const double *columns, int size, int first, int end, const DenseTime &time, double *x,
               double *v) const override
    {
        m_pair.dense(columns, size, first, end, time, x, v);
    }

private:
    int stages() const { return m_pair.tableau().stages + m_pair.extraStages(); }
    double *stageVelocities(const StepAttempt &step) const { return step.scratch + 2 * step.system.size(); }
    double *stageAccelerations(const StepAttempt &step) const
    {
        return step.scratch + (2 + stages()) * step.system.size();
    }
    /// Computes velocities and accelerations of stage `number`, and its positions in `x`.
    void stage(const StepAttempt &step, int number, double *x) const;
    /// Returns the error of a step, px.
    double error(const StepAttempt &step) const;
    /// Returns the largest weighted sum of the velocities or accelerations of all stages (px/frame, or
    /// px/frame^2), or infinity if one is not finite.
    double estimate(const StepAttempt &step, const Tableau::Row &weights) const;

    const EmbeddedPair &m_pair;
};

}
