#pragma once

#include "sim/pipeline/method.h"

#include <vector>

namespace sim {

/// The kernels of one step for some islands. A cache block changes nothing that another one reads, so blocks
/// can run in any order and at the same time.
struct CacheBlock
{
    std::vector<PointRange> ranges;   ///< its points, in ascending order
    std::vector<PreparedKernel> work; ///< in the order in which it runs

    bool contains(int point) const;
};

/// The parameters for dividing a scene into cache blocks.
struct BlockSize
{
    int points = 0;         ///< islands are added to a block until it has this many points
    int minRangeLength = 0; ///< points; if the mean length of ranges is smaller, there are no blocks
};

/// Returns the cache blocks of `phases`, which are one step of `scene`, in the size that was fastest in
/// benchmarks. Empty if blocks would not make the step faster, if a kernel cannot be divided, or if all
/// islands fit into one block.
std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases);
/// Returns the cache blocks in the given size.
std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size);

}
