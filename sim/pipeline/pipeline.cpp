#include "sim/pipeline/pipeline.h"

#include "sim/base/error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace sim {

namespace {

/// Throws if an effect has something to do but no phase computes it. Such a run would silently show another
/// scene.
void checkFit(const Scene &scene, const Method &method, const std::vector<Phase> &phases)
{
    for (const EffectPtr &effect : scene.effects) {
        const bool isComputed = std::any_of(phases.begin(), phases.end(),
                                            [&](const Phase &phase) { return computes(phase, effect); });
        if (!isComputed && effect->count(scene.start, {0, scene.start.pointCount()}) > 0)
            throw Error("method-does-not-fit", {{"method", method.id()}, {"effect", effect->id()}});
    }
}

}

bool computes(const Phase &phase, const EffectPtr &effect)
{
    return phase.effect == effect || std::find(phase.innerEffects.begin(), phase.innerEffects.end(),
                                               effect) != phase.innerEffects.end();
}

StepSize StepSize::ofLength(double h)
{
    if (h >= 1e-6 * (1.0 - 1e-9) && h <= 100.0) {
        const double frames = std::round(h);
        if (h >= 1.0 && std::abs(h - frames) <= 1e-9)
            return {frames, 1, static_cast<int>(frames), 0.0};
        const double steps = std::round(1.0 / h);
        if (h < 1.0 && std::abs(1.0 / h - steps) <= 1e-9 * steps)
            return {1.0 / steps, static_cast<int>(steps), 1, 0.0};
    }
    std::ostringstream text;
    text << h; // not std::to_string, which writes 5e-7 as 0.000000
    throw Error("step-size", {{"h", text.str()}});
}

StepSize StepSize::withTolerance(double tolerance)
{
    if (tolerance >= 1e-13 && tolerance <= 100.0)
        return {1.0, 1, 1, tolerance};
    std::ostringstream text;
    text << tolerance;
    throw Error("tolerance", {{"tolerance", text.str()}});
}

Pipeline compose(const Scene &scene, const Method &method, StepSize step)
{
    const bool adaptive = method.stepping() == Stepping::adaptive;
    if (adaptive != step.isAdaptive())
        throw Error(adaptive ? "needs-tolerance" : "needs-step", {{"method", method.id()}});
    Scene activeScene = scene;
    Pipeline pipeline{{}, step, {}, {}, {}};
    const auto idle = [](const EffectPtr &effect) { return effect->isIdle(); };
    std::copy_if(scene.effects.begin(), scene.effects.end(), std::back_inserter(pipeline.idleEffects), idle);
    std::erase_if(activeScene.effects, idle);
    pipeline.phases = method.phases(activeScene, step);
    checkFit(activeScene, method, pipeline.phases);
    if (pipeline.phases.empty())
        throw Error("nothing-moves", {{"method", method.id()}});
    pipeline.kernels = fusedKernels(pipeline.phases);
    pipeline.blocks = cacheBlocksOf(activeScene, pipeline.phases);
    return pipeline;
}

}
