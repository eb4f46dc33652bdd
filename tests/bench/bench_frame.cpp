// One whole frame of a creature with five feet, gravity and walls: through the pipeline, through the timeline
// with its keyframes, and by a loop over plain doubles. Runs restart before the points rest, because the tiny
// velocities at rest are denormal numbers, which processors compute slowly.

#include "tests/bench/peers/plain_creature.h"
#include "tests/bench/scenes/crowd_numbers.h"
#include "tests/sim/support/support.h"

#include "sim/pipeline/run_step.h"

#include <benchmark/benchmark.h>

namespace {

sim::Script creature(const std::string &method)
{
    return support::script(support::sample("creature in a room"), method);
}

void plain(benchmark::State &run, void (bench::PlainCreature::*frame)())
{
    const sim::State start = sim::sceneOf(creature("published"), creature("published").values).start;
    bench::PlainCreature body;
    for (int i = 0; i < start.pointCount(); ++i) {
        body.x[static_cast<std::size_t>(i)] = start.positionOf(i).x;
        body.y[static_cast<std::size_t>(i)] = start.positionOf(i).y;
    }
    const bench::PlainCreature first = body;
    int done = 0;
    for (auto _ : run) {
        if (done++ == bench::crowd::frames) {
            body = first;
            done = 1;
        }
        (body.*frame)();
        benchmark::DoNotOptimize(body);
    }
}

void pipeline(benchmark::State &run, const std::string &method)
{
    const sim::Script script = creature(method);
    const sim::Scene scene = sim::sceneOf(script, script.values);
    const sim::Pipeline composed = sim::compose(scene, *script.method, script.step);
    sim::State state = scene.start;
    int done = 0;
    for (auto _ : run) {
        if (done++ == bench::crowd::frames) {
            state = scene.start;
            done = 1;
        }
        sim::runStep(composed, state);
        benchmark::DoNotOptimize(state.position.data());
        benchmark::ClobberMemory();
    }
}

/// Measures a frame with all keyframes (a large budget) or none (a budget of 0).
void track(benchmark::State &run, const std::string &method, std::size_t budget)
{
    constexpr int tenMinutes = 18'000;
    const sim::Script script = creature(method);
    for (auto _ : run) {
        sim::Track fresh(script, budget);
        fresh.seek({tenMinutes, 0});
        benchmark::DoNotOptimize(fresh.state().position.data());
    }
    run.SetItemsProcessed(run.iterations() * tenMinutes);
    run.counters["per_frame"] = benchmark::Counter(static_cast<double>(run.iterations()) * tenMinutes,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void plainPublished(benchmark::State &run)
{
    plain(run, &bench::PlainCreature::published);
}
void plainSemiImplicit(benchmark::State &run)
{
    plain(run, &bench::PlainCreature::semiImplicit);
}
void framePublished(benchmark::State &run)
{
    pipeline(run, "published");
}
void frameSemiImplicit(benchmark::State &run)
{
    pipeline(run, "semi_implicit_euler");
}
void tenMinutesNoHistory(benchmark::State &run)
{
    track(run, "semi_implicit_euler", 0);
}
void tenMinutesAllKept(benchmark::State &run)
{
    track(run, "semi_implicit_euler", std::size_t{128} << 20);
}

BENCHMARK(plainPublished);
BENCHMARK(framePublished);
BENCHMARK(plainSemiImplicit);
BENCHMARK(frameSemiImplicit);
BENCHMARK(tenMinutesNoHistory)->Unit(benchmark::kMillisecond);
BENCHMARK(tenMinutesAllKept)->Unit(benchmark::kMillisecond);

}
