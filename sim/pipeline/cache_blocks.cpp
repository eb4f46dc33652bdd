#include "sim/pipeline/cache_blocks.h"

#include "sim/pipeline/fused_motion.h"
#include "sim/scene/islands.h"
#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

namespace {

/// Points per block. A kernel should find in the cache what the previous kernel wrote: a point has 56 bytes
/// in a State, plus the data of effects. In smaller blocks the calls cost more than the cache saves; larger
/// blocks do not fit into every cache. Measured with tests/bench/bench_blocks.cpp. 1536 points are 256
/// creatures with a body and five feet, so their ranges fill vectors and cache lines.
constexpr int pointsPerBlock = 1536;
/// Points. Each range of a block costs one call per kernel, so short ranges would make a step slower.
constexpr int minMeanRangeLength = 16;

/// Returns the points of each block: islands together until a block has `minPoints` points. Ranges are in
/// ascending order, and neighbouring ranges are merged.
std::vector<std::vector<PointRange>> groupIslands(const std::vector<std::vector<PointRange>> &islands,
                                                  int minPoints)
{
    std::vector<std::vector<PointRange>> blocks;
    int filled = minPoints;
    for (const std::vector<PointRange> &island : islands) {
        if (filled >= minPoints) {
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

/// Returns whether `phase` can be divided into blocks without extra cost. A constraint with couplings is not
/// divided: it would go through its whole list for each block.
bool isDivisible(const Phase &phase)
{
    std::vector<Coupling> couplings;
    if (as<Constraint>(phase.effect))
        phase.effect->addCouplings(couplings);
    return phase.points.count > 0 && couplings.empty() &&
           std::all_of(phase.kernels.begin(), phase.kernels.end(),
                       [](const Kernel &kernel) { return kernel.prepareFor != nullptr; });
}

std::vector<PointRange> intersections(const std::vector<PointRange> &ranges, PointRange points)
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
    return cacheBlocksOf(scene, phases, {pointsPerBlock, minMeanRangeLength});
}

std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size)
{
    if (scene.start.pointCount() <= size.points || !std::all_of(phases.begin(), phases.end(), isDivisible))
        return {};
    const std::vector<std::vector<PointRange>> blockRanges = groupIslands(islandsOf(scene), size.points);
    std::size_t rangeCount = 0;
    for (const std::vector<PointRange> &ranges : blockRanges)
        rangeCount += ranges.size();
    if (blockRanges.size() < 2 ||
        scene.start.pointCount() < size.minRangeLength * static_cast<std::ptrdiff_t>(rangeCount))
        return {};
    std::vector<CacheBlock> blocks;
    const std::vector<StepKernel> kernels = fusedKernels(phases);
    for (const std::vector<PointRange> &ranges : blockRanges) {
        CacheBlock block{ranges, {}};
        for (const StepKernel &step : kernels) {
            if (const std::vector<PointRange> common = intersections(ranges, step.points); !common.empty())
                block.work.push_back(step.kernel.prepareFor(common));
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}
