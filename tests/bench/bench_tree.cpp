// One frame of a tree, by branches: the tutorial's last step with the wind blowing, and joints that swing.

#include "sim/effects/damping.h"
#include "sim/effects/gust.h"
#include "sim/effects/joints.h"
#include "sim/effects/return_to_rest.h"
#include "sim/effects/torsion.h"
#include "sim/effects/tree_wind.h"
#include "sim/effects/wind_torque.h"
#include "support.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace {

/// A full tree of `branches` branches or one more: 255, 1001, 10001, 100001.
sim::TreePtr treeOf(long branches)
{
    sim::Tree tree = sim::Tree::ofTrunk(100.0);
    for (int i = 0; tree.branches() < branches; ++i) {
        const auto row = static_cast<std::size_t>(i);
        const double angle = tree.rest[row], scale = 0.9 * tree.scale[row];
        tree.sprout(i, angle - 30.0, scale);
        tree.sprout(i, angle + 30.0, scale);
    }
    return std::make_shared<const sim::Tree>(std::move(tree));
}

sim::Scene sceneOf(const sim::Tree &tree, sim::Inertia inertia)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(tree.branches());
    scene.start.angle = Eigen::Map<const Eigen::ArrayXd>(tree.rest.data(), tree.branches());
    scene.start.place(0, {275.0, 400.0});
    scene.start.outside.pointer = {{60.0, 200.0}};
    scene.start.outside.pointerDown = true;
    scene.groups = {{"branches", {0, tree.branches()}, inertia}};
    for (int i = 0; i < tree.branches(); ++i)
        scene.names.push_back("branch" + std::to_string(i));
    return scene;
}

void frames(benchmark::State &run, const sim::Scene &scene, const std::string &method)
{
    const sim::Script script = support::script(scene, method);
    const sim::Scene prepared = sim::sceneOf(script, script.values);
    const sim::Pipeline pipeline = sim::compose(prepared, *script.method, script.step);
    sim::State state = prepared.start;
    for (auto _ : run) {
        ++state.frame;
        for (const sim::Phase &phase : pipeline.phases)
            phase.run(state);
        benchmark::DoNotOptimize(state.position.data());
        benchmark::ClobberMemory();
    }
    run.counters["per_branch"] =
        benchmark::Counter(static_cast<double>(run.iterations()) * state.points(),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <sim::TreeFormula formula>
void treeInWind(benchmark::State &run)
{
    const sim::TreePtr tree = treeOf(run.range(0));
    sim::Scene scene = sceneOf(*tree, sim::Inertia::none);
    const sim::Resistance resistance{sim::Resistance::By::thickness, 5.0};
    scene.effects = {
        std::make_shared<const sim::ReturnToRest>(tree, 8.0),
        std::make_shared<const sim::Joints>(tree, sim::degreesOf(formula)),
        std::make_shared<const sim::TreeWind>(tree, formula, resistance, sim::Turbulence{20.0, 1})};
    frames(run, scene, "published");
}

void treePublished(benchmark::State &run)
{
    treeInWind<sim::TreeFormula::published>(run);
}
void treeCorrected(benchmark::State &run)
{
    treeInWind<sim::TreeFormula::corrected>(run);
}

void treeThatSwings(benchmark::State &run)
{
    const sim::TreePtr tree = treeOf(run.range(0));
    sim::Scene scene = sceneOf(*tree, sim::Inertia::some);
    scene.start.spin = Eigen::ArrayXd::Zero(tree->branches());
    const sim::Limbs limbs = sim::limbsOf(*tree, 0.05);
    scene.effects = {std::make_shared<const sim::GustFront>(12.0),
                     std::make_shared<const sim::Torsion>(tree, limbs),
                     std::make_shared<const sim::WindTorque>(tree, limbs.inertia, 5.0, 0.6),
                     std::make_shared<const sim::SpinDamping>(0.96),
                     std::make_shared<const sim::Joints>(tree, sim::degreesPerRadian)};
    frames(run, scene, "semi_implicit_euler");
}

BENCHMARK(treePublished)->Arg(255)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);
BENCHMARK(treeCorrected)->Arg(255)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);
BENCHMARK(treeThatSwings)->Arg(255)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);

}
