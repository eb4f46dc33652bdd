// The cost of hard scenes by size: many feet on one body with a stable method, a chain of sticks that is too
// short, and many creatures at once with a small tolerance.

#include "tests/bench/scenes/crowd.h"

#include "sim/catalogue/scenes.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"

#include <benchmark/benchmark.h>

namespace {

/// Measures a frame of `scene` in runs of 50 frames, because points at rest cost less.
void frames(benchmark::State &run, const sim::Scene &scene, const char *id, sim::StepSize step)
{
    constexpr int length = 50;
    const sim::MethodPtr method = sim::findMethod(id);
    const sim::Pipeline pipeline = sim::compose(scene, *method, step);
    sim::State start = scene.start;
    method->prepareState(start);
    sim::State state = start;
    for (auto _ : run) {
        if (state.frame == length)
            state = start;
        ++state.frame;
        for (const sim::Phase &phase : pipeline.phases)
            phase.run(state);
        benchmark::DoNotOptimize(state.position.data());
    }
    run.SetComplexityN(run.range(0));
}

void feetOnOneBody(benchmark::State &run)
{
    const sim::Values values = sim::hard::valuesOf({{"feet", static_cast<double>(run.range(0))},
                                                    {"k", 0.2},
                                                    {"damp", 0.85},
                                                    {"radius", 50.0},
                                                    {"out", 70.0}});
    frames(run, sim::hard::creature(values), "backward_euler", sim::StepSize::ofLength(1.0));
}

void chain(benchmark::State &run)
{
    const sim::Values values = sim::hard::valuesOf({{"links", static_cast<double>(run.range(0))},
                                                    {"stretched", 1.1},
                                                    {"damp", 0.9},
                                                    {"gravity", 0.5},
                                                    {"passes", 20.0}});
    frames(run, sim::hard::stretchedChain(values), "semi_implicit_euler", sim::StepSize::ofLength(1.0));
}

/// Each creature takes its own adaptive steps.
void exactCreatures(benchmark::State &run)
{
    frames(run, bench::crowd::inTheAir(static_cast<int>(run.range(0))), "rkn86",
           sim::StepSize::withTolerance(1e-6));
}

/// The same, with wall contacts at different times.
void exactCrowd(benchmark::State &run)
{
    frames(run, bench::crowd::inTheRoom(static_cast<int>(run.range(0))), "rkn86",
           sim::StepSize::withTolerance(1e-3));
}

BENCHMARK(feetOnOneBody)->Arg(10)->Arg(100)->Arg(1'000)->Arg(10'000)->Complexity();
BENCHMARK(chain)->Arg(10)->Arg(100)->Arg(1'000)->Complexity();
BENCHMARK(exactCreatures)->Arg(1)->Arg(10)->Arg(100)->Complexity();
BENCHMARK(exactCrowd)->Arg(1)->Arg(10)->Arg(100)->Complexity();

}
