#pragma once

#include "sim/pipeline/method.h"

#include <vector>

namespace sim {

/// What one step does to some islands, from its first kernel to its last. Blocks change nothing of each other, so they
/// may run in any order, and at the same time.
struct CacheBlock
{
    std::vector<PointRange> ranges; ///< its points, in ascending order
    std::vector<PreparedKernel> work;

    bool contains(int point) const;
};

/// How a scene is divided into blocks.
struct BlockSize
{
    int points = 0;         ///< islands are put together until a block has so many
    int minRangeLength = 0; ///< where runs have fewer points on the average, there are no blocks
};

/// The blocks of `phases`, one step of `scene`, in the size that pays. Empty where there is nothing to gain or where the
/// step can not be taken apart: it has a kernel that cannot be divided, or all islands go into one block.
std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases);
/// The same in another size.
std::vector<CacheBlock> cacheBlocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size);

}
