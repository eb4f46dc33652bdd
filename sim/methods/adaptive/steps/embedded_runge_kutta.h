#pragma once

#include "sim/methods/adaptive/steps/embedded_pair.h"
#include "sim/methods/adaptive/steps/step_rule.h"

namespace sim {

/// Steps by an embedded pair of explicit Runge-Kutta methods. Damping is exact, at any rate of each row: see
/// StageWeights.
class EmbeddedRungeKutta : public StepRule
{
public:
    explicit EmbeddedRungeKutta(const EmbeddedPair &pair) : m_pair(pair) {}

    int order() const override { return m_pair.order(); }
    /// The place of a stage; velocity and acceleration of each.
    int scratchColumns() const override { return 2 + 2 * stages(); }
    int denseColumns() const override { return m_pair.denseColumns(); }
    double attempt(const StepAttempt &step) const override;
    void makeDense(const StepAttempt &step) const override;
    DenseTime instant(double rate, double h, double theta) const override;
    void dense(const double *columns, int size, int first, int end, const DenseTime &when, double *place,
               double *speed) const override
    {
        m_pair.dense(columns, size, first, end, when, place, speed);
    }

private:
    int stages() const { return m_pair.tableau().stages + m_pair.extraStages(); }
    double *speeds(const StepAttempt &step) const { return step.scratch + 2 * step.system.size(); }
    double *slopes(const StepAttempt &step) const
    {
        return step.scratch + (2 + stages()) * step.system.size();
    }
    /// A stage's velocity and acceleration, at the place that it leaves in `place`.
    void stage(const StepAttempt &step, int number, double *place) const;
    double error(const StepAttempt &step) const;
    /// The largest number that the stages' slopes come to with these weights, px/frame; infinite if one is not finite.
    double estimate(const StepAttempt &step, const Tableau::Row &weights) const;

    const EmbeddedPair &m_pair;
};

}
