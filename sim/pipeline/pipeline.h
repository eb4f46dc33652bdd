#pragma once

#include "sim/pipeline/cache_blocks.h"
#include "sim/pipeline/fused_motion.h"
#include "sim/pipeline/method.h"

#include <cstdint>

namespace sim {

/// The phases of one step, ready to run.
struct Pipeline
{
    std::vector<Phase> phases;
    StepSize step;
    std::vector<EffectPtr> idleEffects; ///< listed, but idle: no phase computes them
    /// The same step for those who do not look into it: kernel after kernel, see fusedKernels().
    std::vector<StepKernel> kernels;
    std::vector<CacheBlock>
        blocks; ///< the same in blocks of islands; empty where that gains nothing. See runStep()

    int phasesPerStep() const { return static_cast<int>(phases.size()); }
    int phasesPerOutput() const { return phasesPerStep() * step.stepsPerOutput; }
    /// The phase that runs as number `index` of a row.
    const Phase &phaseAt(int index) const
    {
        return phases[static_cast<std::size_t>(index % phasesPerStep())];
    }
};

/// Puts a scene and a method together.
/// @throws Error "method-does-not-fit" (method, effect) where they do not go together, "nothing-moves" for a
/// scene in which no point can move, "needs-tolerance" or "needs-step" (method) for the wrong kind of step
Pipeline compose(const Scene &scene, const Method &method, StepSize step);

}
