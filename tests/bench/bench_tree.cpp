// One frame of a tree, by number of branches: the tutorial's last step in the wind, and a tree with spring
// joints.

#include "tests/bench/scenes/tree_scenes.h"

#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"

#include <benchmark/benchmark.h>

namespace {

using namespace bench;

void frames(benchmark::State &run, const sim::Scene &scene, const std::string &id)
{
    const sim::MethodPtr method = sim::findMethod(id);
    const sim::Pipeline pipeline = sim::compose(scene, *method, sim::StepSize::ofLength(1.0));
    sim::State state = scene.start;
    method->prepareState(state);
    for (auto _ : run) {
        ++state.frame;
        sim::runStep(pipeline, state);
        benchmark::DoNotOptimize(state.position.data());
        benchmark::ClobberMemory();
    }
    run.counters["per_branch"] =
        benchmark::Counter(static_cast<double>(run.iterations()) * state.pointCount(),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    run.SetComplexityN(state.pointCount());
}

sim::TreePtr treeOf(const benchmark::State &run)
{
    return trees::full(static_cast<int>(run.range(0)));
}

void treePublished(benchmark::State &run)
{
    frames(run, trees::inTheWind(treeOf(run), sim::TreeFormula::published), "published");
}
void tree(benchmark::State &run)
{
    frames(run, trees::inTheWind(treeOf(run), sim::TreeFormula::corrected), "published");
}
void treeThatSwings(benchmark::State &run)
{
    frames(run, trees::thatSwings(treeOf(run)), "semi_implicit_euler");
}

// The arguments are levels of forks: 255, 4,095, 65,535 and 1,048,575 branches.
BENCHMARK(tree)->Arg(7)->Arg(11)->Arg(15)->Arg(19)->Complexity();
BENCHMARK(treePublished)->Arg(7)->Arg(11)->Arg(15)->Complexity();
BENCHMARK(treeThatSwings)->Arg(7)->Arg(11)->Arg(15)->Complexity();

}
