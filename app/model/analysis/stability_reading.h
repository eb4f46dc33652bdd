#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/analysis/stability/remedies/stick_fit.h"

#include <QElapsedTimer>

#include <memory>
#include <optional>
#include <vector>

namespace app {

/// How far the present step is from its limit, at one moment of a run.
struct StabilityReading
{
    sim::Stability stability;
    std::shared_ptr<const sim::ComposedInterval> interval; ///< the names and effects belong to it
    sim::MethodPtr method;
    sim::StepSize step;
    // Computed only on request:
    std::vector<sim::Remedy> remedies;
    std::optional<sim::StickAdvice> sticks; ///< also empty if the trial runs would take too long
};

/// A reading and the milliseconds that computing it took.
struct TimedReading
{
    std::shared_ptr<const StabilityReading> reading;
    int milliseconds = 0;

    /// Returns how long to wait before the next reading, so that readings take at most a fifth of a processor.
    int pause() const { return 4 * milliseconds; }
};

/// Calls `compute`, which returns a StabilityReading, and times it.
template <class Compute>
TimedReading timedReading(const Compute &compute)
{
    QElapsedTimer clock;
    clock.start();
    auto reading = std::make_shared<const StabilityReading>(compute());
    return {std::move(reading), static_cast<int>(clock.elapsed())};
}

/// Computes a reading without remedies and stick advice. Safe to call from any thread. If the scene cannot be set up,
/// the bound is unknown: the session reports the reason.
StabilityReading readStability(const sim::Script &script,
                               std::shared_ptr<const sim::ComposedInterval> interval,
                               const sim::State &state);

}
