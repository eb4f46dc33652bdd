#include "sim/blocks.h"

#include "sim/islands.h"

#include <algorithm>

namespace sim {

namespace {

/// A pass finds in the processor's cache what the one before it has left there: a point has 56 bytes in a State, and
/// what effects know of it comes on top. In smaller blocks calls cost more than they save, and larger ones do not
/// fit into every cache: see tests/bench/bench_blocks.cpp. Of creatures with five feet these are 256: their runs fill
/// vectors and cache lines, which those of 2,048 points do not, and take 5 % less.
constexpr int pointsInBlock = 1536;
/// A piece costs a call of each pass, and that a search for where it begins.
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

/// Whether `phase` can be divided, and a part costs no more than its share. A constraint that ties goes through its
/// whole list for each part, in the list's own order.
bool isDivisible(const Phase &phase)
{
    std::vector<Tie> ties;
    if (as<Constraint>(phase.effect))
        phase.effect->ties(ties);
    return phase.runOn && phase.points.count > 0 && ties.empty();
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

/// Adds the pieces of phase number `number` to `blocks`.
void addPieces(const Phase &phase, int number, const std::vector<Run> &runs, std::vector<Block> &blocks)
{
    for (auto run = runAt(runs, phase.points.first);
         run != runs.end() && run->points.first < phase.points.end(); ++run) {
        const int first = std::max(run->points.first, phase.points.first);
        const int end = std::min(run->points.end(), phase.points.end());
        blocks[run->block].push_back({number, {first, end - first}});
    }
}

}

std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &phases)
{
    return blocksOf(scene, phases, {pointsInBlock, shortestPiece});
}

std::vector<Block> blocksOf(const Scene &scene, const std::vector<Phase> &phases, BlockSize size)
{
    if (scene.start.points() <= size.points || !std::all_of(phases.begin(), phases.end(), isDivisible))
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
    for (std::size_t i = 0; i < phases.size(); ++i)
        addPieces(phases[i], static_cast<int>(i), runs, blocks);
    return blocks;
}

}
