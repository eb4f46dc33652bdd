// The speed of hand-written code that is optimised for this processor alone: limit_*.h and the loop of
// plain_crowd.h. Each result is first compared with the pipeline's, because a limit that computes something
// else would be meaningless.

#include "tests/bench/peers/by_hand.h"
#include "tests/bench/scenes/tree_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/scenes/cloth.h"

namespace {

using namespace bench;
namespace cloth = scenes::cloth;

constexpr int soon = 5; ///< frames

const benchmark::internal::Benchmark *const entered[] = {
    crowd::enter({"creatures_limit", crowd::inTheRoom, by_hand::creatures, 1e-9, by_hand::missing()}),
    crowd::enter(
        {"creatures_in_air_loop", crowd::inTheAir, by_hand::creaturesInAir, 1e-9, by_hand::missing()}),
};

/// Returns whether `limit` can run on this machine and agrees with the pipeline after some frames. Reports
/// the reason if not.
template <class Limit>
bool isRight(benchmark::State &run, const Limit &limit, const sim::State &right)
{
    double most = 0.0;
    for (int point = 0; point < right.pointCount(); ++point)
        most = std::max(most, sim::length(limit.at(point) - right.positionOf(point)));
    run.counters["px_apart"] = most;
    const bool holds = most < 1e-6;
    if (!holds)
        run.SkipWithError(("computes something else: " + std::to_string(most) + " px off").c_str());
    return holds;
}

bool isAble(benchmark::State &run)
{
    const std::string missing = by_hand::missing();
    if (!missing.empty())
        run.SkipWithError(missing.c_str());
    return missing.empty();
}

void clothLimit(benchmark::State &run)
{
    if (!isAble(run))
        return;
    const int side = static_cast<int>(run.range(0));
    const sim::Scene scene = cloth::hung(side, cloth::soft, cloth::calm);
    by_hand::Cloth limit(scene, side, {cloth::soft, cloth::spacing, cloth::weight, cloth::calm});
    for (int i = 0; i < soon; ++i)
        limit.frame();
    if (!isRight(run, limit, support::plainRun(scene, "semi_implicit_euler", 1.0, soon)))
        return;
    for (auto _ : run) {
        limit.frame();
        benchmark::ClobberMemory();
    }
    run.SetComplexityN(side * side);
}

void treeLimit(benchmark::State &run)
{
    if (!isAble(run))
        return;
    const int forks = static_cast<int>(run.range(0));
    const sim::Scene scene = trees::inTheWind(trees::full(forks), sim::TreeFormula::corrected);
    by_hand::Tree limit(forks);
    std::int64_t number = 0;
    while (number < soon)
        limit.frame(++number);
    if (!isRight(run, limit, support::plainRun(scene, "published", 1.0, soon)))
        return;
    for (auto _ : run) {
        limit.frame(++number);
        benchmark::ClobberMemory();
    }
    run.SetComplexityN(scene.start.pointCount());
}

BENCHMARK(clothLimit)->Arg(32)->Arg(64)->Arg(128)->Arg(256)->Complexity();
BENCHMARK(treeLimit)->Arg(7)->Arg(11)->Arg(15)->Arg(19)->Complexity();

}
