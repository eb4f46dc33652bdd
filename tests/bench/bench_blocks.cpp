// One step of a crowd: pass by pass over all points, in cache blocks of islands, and in blocks that two
// threads share. Times are processor time, except for the threads, which are measured by wall-clock time.

#include "tests/bench/scenes/crowd.h"

#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"

#include <benchmark/benchmark.h>

namespace {

/// A crowd and its run by semi-implicit Euler. The run restarts every bench::crowd::frames frames.
struct Crowd
{
    explicit Crowd(int creatures) : scene(bench::crowd::inTheRoom(creatures))
    {
        const sim::MethodPtr method = sim::findMethod("semi_implicit_euler");
        method->prepareState(scene.start);
        pipeline = sim::compose(scene, *method, sim::StepSize::ofLength(1.0));
        state = scene.start;
    }

    void nextFrame()
    {
        if (state.frame == bench::crowd::frames)
            state = scene.start;
        ++state.frame;
    }

    sim::Scene scene;
    sim::Pipeline pipeline;
    sim::State state;
};

void byPass(benchmark::State &run, int creatures)
{
    Crowd crowd(creatures);
    for (auto _ : run) {
        crowd.nextFrame();
        for (const sim::Phase &phase : crowd.pipeline.phases)
            phase.run(crowd.state);
        benchmark::ClobberMemory();
    }
    run.SetItemsProcessed(run.iterations() * creatures);
}

void inBlocks(benchmark::State &run, int creatures, int threads)
{
    Crowd crowd(creatures);
    sim::ThreadPool pool(threads);
    for (auto _ : run) {
        crowd.nextFrame();
        sim::runStep(crowd.pipeline, crowd.state, pool);
        benchmark::ClobberMemory();
    }
    run.SetItemsProcessed(run.iterations() * creatures);
    run.counters["blocks"] = static_cast<double>(crowd.pipeline.blocks.size());
}

/// Measures a step with blocks of different sizes.
void bySize(benchmark::State &run, int creatures)
{
    Crowd crowd(creatures);
    const int points = static_cast<int>(run.range(0));
    crowd.pipeline.blocks = sim::cacheBlocksOf(crowd.scene, crowd.pipeline.phases, {points, 1});
    for (auto _ : run) {
        crowd.nextFrame();
        sim::runStep(crowd.pipeline, crowd.state);
        benchmark::ClobberMemory();
    }
}

int registerAll()
{
    for (const int creatures : {100, 1'000, 10'000, 100'000}) {
        const std::string count = std::to_string(creatures);
        const std::string passes = "crowd_by_pass_" + count, blocks = "crowd_in_blocks_" + count;
        const std::string one = "crowd_one_thread_" + count, two = "crowd_two_threads_" + count;
        const auto name = [](const std::string &text) { return text.c_str(); };
        benchmark::RegisterBenchmark(name(passes), byPass, creatures);
        benchmark::RegisterBenchmark(name(blocks), inBlocks, creatures, 1);
        benchmark::RegisterBenchmark(name(one), inBlocks, creatures, 1)->UseRealTime();
        benchmark::RegisterBenchmark(name(two), inBlocks, creatures, 2)->UseRealTime();
    }
    auto *const sizes = benchmark::RegisterBenchmark("crowd_block_size", bySize, 10'000);
    for (const int points : {384, 768, 1536, 2048, 3072, 4096, 6144, 12'288})
        sizes->Arg(points);
    return 0;
}

const int registered = registerAll();

}
