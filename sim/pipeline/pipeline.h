#pragma once

#include "sim/pipeline/cache_blocks.h"
#include "sim/pipeline/fused_motion.h"
#include "sim/pipeline/method.h"

#include <cstdint>

namespace sim {

/// One step of a scene under a method, ready to run.
struct Pipeline
{
    std::vector<Phase> phases;
    StepSize step;
    std::vector<EffectPtr> idleEffects; ///< effects of the scene without a phase, because they are idle
    /// The same step for running without stopping between phases. See fusedKernels().
    std::vector<StepKernel> kernels;
    /// The same step divided into cache blocks; empty if that is not faster. See runStep().
    std::vector<CacheBlock> blocks;

    int phasesPerStep() const { return static_cast<int>(phases.size()); }
    int phasesPerOutput() const { return phasesPerStep() * step.stepsPerOutput; }
    /// Returns the phase with the index `index` within an output step.
    const Phase &phaseAt(int index) const
    {
        return phases[static_cast<std::size_t>(index % phasesPerStep())];
    }
};

/// Returns whether `phase` computes `effect`, alone or among its inner effects.
bool computes(const Phase &phase, const EffectPtr &effect);

/// Composes a scene and a method into a pipeline.
/// @throws Error "method-does-not-fit" (method, effect) if the method cannot handle an effect,
/// "nothing-moves" (method) if no point can move, "needs-tolerance" or "needs-step" (method) for the wrong
/// kind of step size
Pipeline compose(const Scene &scene, const Method &method, StepSize step);

}
