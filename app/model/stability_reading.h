#pragma once

#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/analysis/stability/remedies/stick_fit.h"

#include <memory>
#include <optional>
#include <vector>

namespace app {

/// How far the step in use is from its limit, at one moment of a run.
struct StabilityReading
{
    sim::Stability stability;
    std::shared_ptr<const sim::ComposedInterval> interval; ///< whose names and effects those are
    sim::MethodPtr method;
    sim::StepSize step;
    // Looked for only while somebody reads them:
    std::vector<sim::Remedy> remedies;
    std::optional<sim::StickAdvice> sticks; ///< empty also where trials would take too long
};

/// Reads it, without what somebody reads besides. May be called from any thread. Where the scene cannot be, the bound is
/// unknown: the session says why.
StabilityReading readStability(const sim::Script &script,
                               std::shared_ptr<const sim::ComposedInterval> interval,
                               const sim::State &state);

}
