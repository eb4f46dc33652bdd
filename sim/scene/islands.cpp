#include "sim/scene/islands.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <numeric>

namespace sim {

namespace {

/// A union-find structure of points. Source: Galler and Fischer, "An improved equivalence algorithm", 1964.
class DisjointSets
{
public:
    explicit DisjointSets(int points) : m_parents(static_cast<std::size_t>(points))
    {
        std::iota(m_parents.begin(), m_parents.end(), 0);
    }

    /// Returns the lowest point of the set that contains `point`.
    int lowest(int point)
    {
        while (parent(point) != point) {
            parent(point) = parent(parent(point)); // path halving: makes the next search shorter
            point = parent(point);
        }
        return point;
    }

    void unite(const Coupling &coupling)
    {
        const auto [low, high] = std::minmax({lowest(coupling.first), lowest(coupling.second)});
        parent(high) = low;
    }

private:
    int &parent(int point) { return m_parents[static_cast<std::size_t>(point)]; }

    std::vector<int> m_parents; ///< per point: a point of the same set, or itself if it is the lowest
};

bool isActive(const Effect &effect, const Scene &scene)
{
    return !effect.isIdle() && effect.count(scene.start, {0, scene.start.pointCount()}) > 0;
}

}

std::vector<std::vector<PointRange>> islandsOf(const Scene &scene)
{
    const int points = scene.start.pointCount();
    std::vector<Coupling> couplings;
    for (const EffectPtr &effect : scene.effects) {
        if (!isActive(*effect, scene))
            continue;
        if (effect->dependence() != Dependence::coupledPoints)
            return {{{0, points}}};
        effect->addCouplings(couplings);
    }
    DisjointSets sets(points);
    for (const Coupling &coupling : couplings)
        sets.unite(coupling);
    std::vector<std::vector<PointRange>> islands;
    std::vector<std::size_t> islandOf(static_cast<std::size_t>(points)); // only valid for lowest points
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
    std::vector<PointRange> merged;
    for (const PointRange &range : ranges) {
        if (!merged.empty() && merged.back().end() == range.first)
            merged.back().count += range.count;
        else
            merged.push_back(range);
    }
    return merged;
}

}
