#include "sim/pipeline/cache_blocks.h"

#include "sim/pipeline/fused_motion.h"
#include "sim/scene/islands.h"
#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

namespace {

/// A kernel finds in the processor's cache what the one before it has left there: a point has 56 bytes in a State, and
/// what effects know of it comes on top. In smaller blocks calls cost more than they save, and larger ones do not
/// fit into every cache: see tests/bench/bench_blocks.cpp. Of creatures with five feet these are 256: their runs fill
/// vectors and cache lines.
constexpr int pointsInBlock = 1536;
/// A run costs a call of each kernel.
constexpr int shortestRun = 16;

/// The points of each block in ascending order, neighbours made one run.
std::vector<std::vector<Points>> divided(const std::vector<std::vector<Points>> &islands, int full)
{
    std::vector<std::vector<Points>> blocks;
    int filled = full;
    for (const std::vector<Points> &island : islands) {
        if (filled >= full) {
            blocks.emplace_back();
            filled = 0;
        }
        for (const Points &run : island) {
            blocks.back().push_back(run);
            filled += run.count;
        }
    }
    for (std::vector<Points> &runs : blocks)
        runs = inOrder(std::move(runs));
    return blocks;
}

/// Whether `phase` can be divided, and a part costs no more than its share. A constraint that ties goes through its
/// whole list for each part, in the list's own order.
bool isDivisible(const Phase &phase)
{
    std::vector<Tie> ties;
    if (as<Constraint>(phase.effect))
        phase.effect->ties(ties);
    return phase.points.count > 0 && ties.empty() &&
           std::all_of(phase.kernels.begin(), phase.kernels.end(),
                       [](const Kernel &kernel) { return kernel.part != nullptr; });
}

std::vector<Points> common(const std::vector<Points> &runs, Points points)
{
    std::vector<Points> parts;
    for (const Points &run : runs) {
        if (const Points part = common(run, points); part.count > 0)
            parts.push_back(part);
    }
    return parts;
}

}

bool Block::contains(int point) const
{
    return std::any_of(runs.begin(), runs.end(), [point](Points run) { return run.contains(point); });
}

std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &phases)
{
    return blocksOf(scene, phases, {pointsInBlock, shortestRun});
}

std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size)
{
    if (scene.start.points() <= size.points || !std::all_of(phases.begin(), phases.end(), isDivisible))
        return {};
    const std::vector<std::vector<Points>> all = divided(islandsOf(scene), size.points);
    std::size_t runs = 0;
    for (const std::vector<Points> &block : all)
        runs += block.size();
    if (all.size() < 2 || scene.start.points() < size.shortest * static_cast<std::ptrdiff_t>(runs))
        return {};
    std::vector<Block> blocks;
    const std::vector<StepKernel> kernels = fusedKernels(phases);
    for (const std::vector<Points> &points : all) {
        Block block{points, {}};
        for (const StepKernel &one : kernels) {
            if (const std::vector<Points> part = common(points, one.points); !part.empty())
                block.work.push_back(one.kernel.part(part));
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}
