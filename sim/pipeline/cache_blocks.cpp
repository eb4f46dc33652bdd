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
std::vector<std::vector<PointRange>> divided(const std::vector<std::vector<PointRange>> &islands, int full)
{
    std::vector<std::vector<PointRange>> blocks;
    int filled = full;
    for (const std::vector<PointRange> &island : islands) {
        if (filled >= full) {
            blocks.emplace_back();
            filled = 0;
        }
        for (const PointRange &range : island) {
            blocks.back().push_back(range);
            filled += range.count;
        }
    }
    for (std::vector<PointRange> &ranges : blocks)
        ranges = sortedRanges(std::move(ranges));
    return blocks;
}

/// Whether `phase` can be divided, and a part costs no more than its share. A constraint that ties goes through its
/// whole list for each part, in the list's own order.
bool isDivisible(const Phase &phase)
{
    std::vector<Coupling> ties;
    if (as<Constraint>(phase.effect))
        phase.effect->addCouplings(ties);
    return phase.points.count > 0 && ties.empty() &&
           std::all_of(phase.kernels.begin(), phase.kernels.end(),
                       [](const Kernel &kernel) { return kernel.prepareFor != nullptr; });
}

std::vector<PointRange> common(const std::vector<PointRange> &ranges, PointRange points)
{
    std::vector<PointRange> parts;
    for (const PointRange &range : ranges) {
        if (const PointRange part = intersection(range, points); part.count > 0)
            parts.push_back(part);
    }
    return parts;
}

}

bool CacheBlock::contains(int point) const
{
    return std::any_of(ranges.begin(), ranges.end(),
                       [point](PointRange range) { return range.contains(point); });
}

std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases)
{
    return cacheBlocksOf(scene, phases, {pointsInBlock, shortestRun});
}

std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size)
{
    if (scene.start.pointCount() <= size.points || !std::all_of(phases.begin(), phases.end(), isDivisible))
        return {};
    const std::vector<std::vector<PointRange>> all = divided(islandsOf(scene), size.points);
    std::size_t runs = 0;
    for (const std::vector<PointRange> &block : all)
        runs += block.size();
    if (all.size() < 2 || scene.start.pointCount() < size.minRangeLength * static_cast<std::ptrdiff_t>(runs))
        return {};
    std::vector<CacheBlock> blocks;
    const std::vector<StepKernel> kernels = fusedKernels(phases);
    for (const std::vector<PointRange> &points : all) {
        CacheBlock block{points, {}};
        for (const StepKernel &one : kernels) {
            if (const std::vector<PointRange> part = common(points, one.points); !part.empty())
                block.work.push_back(one.kernel.prepareFor(part));
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}
