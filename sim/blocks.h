#pragma once

#include "sim/method.h"

#include <vector>

namespace sim {

/// The work of one pass on some of its points.
struct Piece
{
    int pass = 0; ///< index into a pipeline's passes
    Points points;
};

/// What one step does to some islands, from its first pass to its last. Blocks change nothing of each other, so they
/// may run in any order, and at the same time.
using Block = std::vector<Piece>;

/// How a scene is divided into blocks.
struct BlockSize
{
    int points = 0;   ///< islands are put together until a block has so many
    int shortest = 0; ///< where pieces have fewer points on the average, there are no blocks
};

/// The blocks of `passes`, one step of `scene`, in the size that pays. Empty where there is nothing to gain or where the
/// step can not be taken apart: it has a pass that cannot be divided, or all islands go into one block.
std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &passes);
/// The same in another size.
std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &passes, BlockSize size);

}
