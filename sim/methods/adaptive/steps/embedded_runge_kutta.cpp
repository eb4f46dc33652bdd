#include "sim/methods/adaptive/steps/embedded_runge_kutta.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

void EmbeddedRungeKutta::stage(const StepAttempt &step, int number, double *x) const
{
    const std::vector<OdeSystem::RateRange> &rateRanges = step.system.rateRanges();
    const int size = step.system.size();
    const auto row = static_cast<std::size_t>(number);
    for (std::size_t i = 0; i < rateRanges.size(); ++i) {
        const StageWeights &weights = (*step.weights)[i];
        blendRows(x, step.x, 1.0, stageVelocities(step), weights.position[row].data(), number,
                  rateRanges[i].first, rateRanges[i].end(), size);
        blendRows(stageVelocities(step) + number * size, step.v, weights.keep[row], stageAccelerations(step),
                  weights.velocity[row].data(), number, rateRanges[i].first, rateRanges[i].end(), size);
    }
    step.accelerations.at(x, stageVelocities(step) + number * size,
                          step.start + m_pair.tableau().c[row] * step.h,
                          stageAccelerations(step) + number * size);
}

// Shown lines are short.
// clang-format off
//! [embedded_step]
double EmbeddedRungeKutta::attempt(
    const StepAttempt &step) const
{
    int size = step.system.size();
    std::copy_n(step.v, size,
                stageVelocities(step));
    std::copy_n(step.a, size,
                stageAccelerations(step));
    const auto &rows =
        step.system.rateRanges();
    const auto &table = m_pair.tableau();
    for (std::size_t i = 0;
         i < rows.size(); ++i)
        (*step.weights)[i].set(table,
            rows[i].rate, step.h, stages());
    int last = table.stages - 1;
    for (int i = 1; i <= last; ++i)
        stage(step, i, step.endX);
    std::copy_n(
        stageVelocities(step) + last * size,
        size, step.endV);
    std::copy_n(
        stageAccelerations(step) + last * size,
        size, step.endA);
    return error(step);
}
//! [embedded_step]
// clang-format on

double EmbeddedRungeKutta::error(const StepAttempt &step) const
{
    const double largest = estimate(step, m_pair.error());
    if (!std::isfinite(largest))
        return std::numeric_limits<double>::infinity();
    if (!m_pair.hasLowerError())
        return step.h * largest;
    // The two estimates are combined as in DOP853: the lower one counts only if it is much larger.
    const double lower = estimate(step, m_pair.lowerError());
    const double combined = largest > 0.0 ? largest * (largest / std::hypot(largest, 0.1 * lower)) : 0.0;
    return step.h * (lower > 0.0 ? combined : largest);
}

double EmbeddedRungeKutta::estimate(const StepAttempt &step, const Tableau::Row &weights) const
{
    const std::vector<OdeSystem::RateRange> &rateRanges = step.system.rateRanges();
    const int stageCount = m_pair.tableau().stages, size = step.system.size();
    double *sum = step.scratch;
    double largest = 0.0;
    for (std::size_t n = 0; n < rateRanges.size(); ++n) {
        const int first = rateRanges[n].first, end = rateRanges[n].end();
        Tableau::Row damped{}; // weights times the damping factor from each stage to the end of the step
        const auto &keep = (*step.weights)[n].keep;
        for (std::size_t j = 0; j < static_cast<std::size_t>(stageCount); ++j)
            damped[j] =
                keep[j] > 0.0 ? weights[j] * keep[static_cast<std::size_t>(stageCount) - 1] / keep[j] : 0.0;
        const double *v = stageVelocities(step), *a = stageAccelerations(step);
        blendRows(sum, v, 0.0, v, weights.data(), stageCount, first, end, size);
        largest = std::max(largest, maxAbs(sum + first, end - first));
        blendRows(sum, a, 0.0, a, damped.data(), stageCount, first, end, size);
        largest = std::max(largest, maxAbs(sum + first, end - first));
    }
    return largest;
}

void EmbeddedRungeKutta::makeDense(const StepAttempt &step) const
{
    const int size = step.system.size();
    for (int i = m_pair.tableau().stages; i < stages(); ++i)
        stage(step, i, step.scratch + size);
    StepData data{step.x, step.v, stageVelocities(step), stageAccelerations(step), size, 0, 0, 0.0,
                  step.h, nullptr};
    for (std::size_t n = 0; n < step.system.rateRanges().size(); ++n) {
        const OdeSystem::RateRange &rows = step.system.rateRanges()[n];
        data.keep = (*step.weights)[n].keep.data();
        data.first = rows.first;
        data.end = rows.end();
        data.rate = std::isinf(rows.rate) ? 0.0 : rows.rate; // the points stand still
        m_pair.makeDense(data, step.endX, step.endV, step.columns);
    }
}

DenseTime EmbeddedRungeKutta::instant(double rate, double h, double theta) const
{
    return {h, theta, dampingFactor(rate, h * theta), 0.0, 0.0};
}

}
