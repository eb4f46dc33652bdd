#include "sim/pipeline/run_step.h"

#include <algorithm>

namespace sim {

namespace {

/// So many take 70 us on one thread: 4 us each in bench_blocks, where 10,000 creatures are 40 blocks.
constexpr std::size_t blocksWorthSharing = 16;

/// Blocks share State::previous: the first phase that keeps places there would make room for all of them.
void makeRoom(const Pipeline &pipeline, State &state)
{
    const auto constrains = [](const Phase &phase) { return as<Constraint>(phase.effect) != nullptr; };
    const bool remembers = std::any_of(pipeline.phases.begin(), pipeline.phases.end(), constrains);
    if (remembers && state.previous.rows() != state.pointCount())
        state.previous = state.position;
}

void runKernels(const Pipeline &pipeline, State &state)
{
    for (const StepKernel &step : pipeline.kernels)
        step.kernel.run(state);
}

}

void runStep(const Pipeline &pipeline, State &state)
{
    if (pipeline.blocks.empty()) {
        runKernels(pipeline, state);
        return;
    }
    ThreadPool alone(1);
    runStep(pipeline, state, alone);
}

void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool)
{
    runStep(pipeline, state, pool, {});
}

void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool, const std::vector<char> &asleep)
{
    if (pipeline.blocks.empty()) {
        runKernels(pipeline, state);
        return;
    }
    makeRoom(pipeline, state);
    const int blocks = static_cast<int>(pipeline.blocks.size());
    const auto run = [&](int number) {
        const auto block = static_cast<std::size_t>(number);
        if (!asleep.empty() && asleep[block] != 0)
            return;
        for (const PreparedKernel &work : pipeline.blocks[block].work)
            work(state);
    };
    const auto sleepers = static_cast<std::size_t>(std::count(asleep.begin(), asleep.end(), 1));
    if (pipeline.blocks.size() - sleepers >= blocksWorthSharing) {
        pool.parallelFor(blocks, run);
    } else {
        for (int i = 0; i < blocks; ++i)
            run(i);
    }
}

}
