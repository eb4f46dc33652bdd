#include "sim/blocks.h"

#include "sim/islands.h"

#include <algorithm>

namespace sim {

namespace {

/// A phase finds in the processor's cache what the one before it has left there: a point has 56 bytes in a State, and
/// what effects know of it comes on top. In smaller blocks calls cost more than they save, and larger ones do not
/// fit into every cache: see tests/bench/bench_blocks.cpp.
constexpr int pointsInBlock = 2048;
/// A piece costs a call of each phase, and that a search for where it begins.
constexpr int shortestPiece = 16;

/// A run of points, and the block that it is in.
struct Run
{
    Points points;
    std::size_t block = 0;
};

int pointsIn(const std::vector<Points> &runs)
{
    int sum = 0;
    for (const Points &run : runs)
        sum += run.count;
    return sum;
}

/// The runs of all blocks in ascending order, neighbours of one block made one.
std::vector<Run> runsOf(const std::vector<std::vector<Points>> &islands, int full)
{
    std::vector<Run> runs;
    std::size_t block = 0;
    int filled = 0;
    for (const std::vector<Points> &island : islands) {
        if (filled >= full) {
            ++block;
            filled = 0;
        }
        for (const Points &points : island)
            runs.push_back({points, block});
        filled += pointsIn(island);
    }
    std::sort(runs.begin(), runs.end(),
              [](const Run &a, const Run &b) { return a.points.first < b.points.first; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < runs.size(); ++i) {
        if (runs[i].block == runs[last].block)
            runs[last].points.count += runs[i].points.count;
        else
            runs[++last] = runs[i];
    }
    runs.resize(std::min(runs.size(), last + 1));
    return runs;
}

/// The first run that is not all before `point`.
std::vector<Run>::const_iterator runAt(const std::vector<Run> &runs, int point)
{
    return std::upper_bound(runs.begin(), runs.end(), point,
                            [](int at, const Run &run) { return at < run.points.end(); });
}

/// A constraint that ties goes through its list in an order of its own, so it has to see what it ties in one piece.
bool wantsOnePiece(const Phase &phase)
{
    std::vector<Tie> ties;
    if (dynamic_cast<const Constraint *>(phase.effect.get()))
        phase.effect->ties(ties);
    return !ties.empty();
}

bool areLongEnough(const std::vector<Phase> &phases, const std::vector<Run> &runs, int shortest)
{
    std::ptrdiff_t pieces = 0, points = 0;
    for (const Phase &phase : phases) {
        pieces += runAt(runs, phase.points.end() - 1) - runAt(runs, phase.points.first) + 1;
        points += phase.points.count;
    }
    return points >= shortest * pieces;
}

/// Adds the pieces of phase number `phase` to `blocks`. Returns false where one block would need several, and may not.
bool addPieces(const Phase &phase, int number, const std::vector<Run> &runs, std::vector<Block> &blocks)
{
    const bool onePiece = wantsOnePiece(phase);
    for (auto run = runAt(runs, phase.points.first);
         run != runs.end() && run->points.first < phase.points.end(); ++run) {
        Block &block = blocks[run->block];
        if (onePiece && !block.empty() && block.back().phase == number)
            return false;
        const int first = std::max(run->points.first, phase.points.first);
        const int end = std::min(run->points.end(), phase.points.end());
        block.push_back({number, {first, end - first}});
    }
    return true;
}

}

std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &phases)
{
    return blocksOf(scene, phases, {pointsInBlock, shortestPiece});
}

std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size)
{
    const bool apart = std::all_of(phases.begin(), phases.end(),
                                   [](const Phase &phase) { return phase.runOn && phase.points.count > 0; });
    if (!apart || scene.start.points() <= size.points)
        return {};
    const std::vector<Run> runs = runsOf(islandsOf(scene), size.points);
    if (!areLongEnough(phases, runs, size.shortest))
        return {};
    std::size_t last = 0;
    for (const Run &run : runs)
        last = std::max(last, run.block);
    if (last == 0)
        return {};
    std::vector<Block> blocks(last + 1);
    for (std::size_t i = 0; i < phases.size(); ++i) {
        if (!addPieces(phases[i], static_cast<int>(i), runs, blocks))
            return {};
    }
    return blocks;
}

}
