#include "sim/scene/islands.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <numeric>

namespace sim {

namespace {

/// Sets of points that can be united. Source: Galler and Fischer, "An improved equivalence algorithm", 1964.
class DisjointSets
{
public:
    explicit DisjointSets(int points) : m_above(static_cast<std::size_t>(points))
    {
        std::iota(m_above.begin(), m_above.end(), 0);
    }

    /// The lowest point of the set that `point` is in.
    int lowest(int point)
    {
        while (above(point) != point) {
            above(point) = above(above(point)); // so the next way is half as long
            point = above(point);
        }
        return point;
    }

    void unite(const Coupling &tie)
    {
        const auto [low, high] = std::minmax({lowest(tie.first), lowest(tie.second)});
        above(high) = low;
    }

private:
    int &above(int point) { return m_above[static_cast<std::size_t>(point)]; }

    std::vector<int> m_above; ///< a point of the same set each, itself where it is the lowest
};

bool acts(const Effect &effect, const Scene &scene)
{
    return !effect.isIdle() && effect.count(scene.start, {0, scene.start.pointCount()}) > 0;
}

}

std::vector<std::vector<PointRange>> islandsOf(const Scene &scene)
{
    const int points = scene.start.pointCount();
    std::vector<Coupling> ties;
    for (const EffectPtr &effect : scene.effects) {
        if (!acts(*effect, scene))
            continue;
        if (effect->dependence() != Dependence::coupledPoints)
            return {{{0, points}}};
        effect->addCouplings(ties);
    }
    DisjointSets sets(points);
    for (const Coupling &tie : ties)
        sets.unite(tie);
    std::vector<std::vector<PointRange>> islands;
    std::vector<std::size_t> islandOf(static_cast<std::size_t>(points)); // of each set's lowest point
    for (int i = 0; i < points; ++i) {
        const int lowest = sets.lowest(i);
        if (lowest == i) {
            islandOf[static_cast<std::size_t>(i)] = islands.size();
            islands.emplace_back();
        }
        std::vector<PointRange> &ranges = islands[islandOf[static_cast<std::size_t>(lowest)]];
        if (!ranges.empty() && ranges.back().end() == i)
            ++ranges.back().count;
        else
            ranges.push_back({i, 1});
    }
    return islands;
}

std::vector<PointRange> sortedRanges(std::vector<PointRange> ranges)
{
    std::sort(ranges.begin(), ranges.end(), [](PointRange a, PointRange b) { return a.first < b.first; });
    std::vector<PointRange> fewer;
    for (const PointRange &range : ranges) {
        if (!fewer.empty() && fewer.back().end() == range.first)
            fewer.back().count += range.count;
        else
            fewer.push_back(range);
    }
    return fewer;
}

}
