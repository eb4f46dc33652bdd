#include "sim/pipeline/run_step.h"

#include <algorithm>

namespace sim {

namespace {

/// With fewer blocks a step is not divided among threads. This many take about 70 us on one thread: in
/// bench_blocks, 10,000 creatures are 40 blocks of 4 us each.
constexpr std::size_t minBlocksForThreads = 16;

/// Allocates State::previous before the blocks run. They share it, so none of them may allocate it while
/// others run.
void allocatePrevious(const Pipeline &pipeline, State &state)
{
    const auto isConstraint = [](const Phase &phase) { return as<Constraint>(phase.effect) != nullptr; };
    const bool hasConstraint = std::any_of(pipeline.phases.begin(), pipeline.phases.end(), isConstraint);
    if (hasConstraint && state.previous.rows() != state.pointCount())
        state.previous = state.position;
}

void runKernels(const Pipeline &pipeline, State &state)
{
    for (const StepKernel &kernel : pipeline.kernels)
        kernel.kernel.run(state);
}

}

void runStep(const Pipeline &pipeline, State &state)
{
    if (pipeline.blocks.empty()) {
        runKernels(pipeline, state);
        return;
    }
    ThreadPool singleThread(1);
    runStep(pipeline, state, singleThread);
}

void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool)
{
    runStep(pipeline, state, pool, {});
}

void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool, const std::vector<char> &sleeping)
{
    if (pipeline.blocks.empty()) {
        runKernels(pipeline, state);
        return;
    }
    allocatePrevious(pipeline, state);
    const int blocks = static_cast<int>(pipeline.blocks.size());
    const auto run = [&](int block) {
        const auto index = static_cast<std::size_t>(block);
        if (!sleeping.empty() && sleeping[index] != 0)
            return;
        for (const PreparedKernel &work : pipeline.blocks[index].work)
            work(state);
    };
    const auto sleepingBlocks = static_cast<std::size_t>(std::count(sleeping.begin(), sleeping.end(), 1));
    if (pipeline.blocks.size() - sleepingBlocks >= minBlocksForThreads) {
        pool.parallelFor(blocks, run);
    } else {
        for (int i = 0; i < blocks; ++i)
            run(i);
    }
}

}
