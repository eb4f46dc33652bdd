#pragma once

#include "sim/method.h"

#include <cstdint>

namespace sim {

/// The step of a run. Rows are what is kept and written: one a frame, or one a step when that is longer.
struct StepSize
{
    double h = 1.0;    ///< frames
    int perRow = 1;    ///< steps a row: n for h = 1/n
    int rowFrames = 1; ///< frames a row: h itself when it is whole

    /// @throws Error "step-size" (h) unless 1/h or h is whole (to 1e-9) and h is from 1e-6 to 100
    static StepSize of(double h);
    friend bool operator==(const StepSize &, const StepSize &) = default;
};

/// The phases of one step, ready to run.
struct Pipeline
{
    std::vector<Phase> phases;
    StepSize step;

    int phasesPerStep() const { return static_cast<int>(phases.size()); }
    int phasesPerRow() const { return phasesPerStep() * step.perRow; }
    /// The phase that runs as number `index` of a row.
    const Phase &phaseAt(int index) const
    {
        return phases[static_cast<std::size_t>(index % phasesPerStep())];
    }
};

/// Puts a scene and a method together.
/// @throws Error "method-does-not-fit" (method, effect) where they do not go together, "nothing-moves" for a
/// scene in which no point can move
Pipeline compose(const Scene &scene, const Method &method, StepSize step);

}
