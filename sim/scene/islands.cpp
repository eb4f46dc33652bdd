#include "sim/scene/islands.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <numeric>

namespace sim {

namespace {

/// Sets of points that can be united. Source: Galler and Fischer, "An improved equivalence algorithm", 1964.
class Sets
{
public:
    explicit Sets(int points) : m_above(static_cast<std::size_t>(points))
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

    void unite(const Tie &tie)
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
    return !effect.idle() && effect.count(scene.start, {0, scene.start.points()}) > 0;
}

}

std::vector<std::vector<Points>> islandsOf(const Scene &scene)
{
    const int points = scene.start.points();
    std::vector<Tie> ties;
    for (const EffectPtr &effect : scene.effects) {
        if (!acts(*effect, scene))
            continue;
        if (effect->sees() != Sees::tied)
            return {{{0, points}}};
        effect->ties(ties);
    }
    Sets sets(points);
    for (const Tie &tie : ties)
        sets.unite(tie);
    std::vector<std::vector<Points>> islands;
    std::vector<std::size_t> islandOf(static_cast<std::size_t>(points)); // of each set's lowest point
    for (int i = 0; i < points; ++i) {
        const int lowest = sets.lowest(i);
        if (lowest == i) {
            islandOf[static_cast<std::size_t>(i)] = islands.size();
            islands.emplace_back();
        }
        std::vector<Points> &runs = islands[islandOf[static_cast<std::size_t>(lowest)]];
        if (!runs.empty() && runs.back().end() == i)
            ++runs.back().count;
        else
            runs.push_back({i, 1});
    }
    return islands;
}

std::vector<Points> inOrder(std::vector<Points> runs)
{
    std::sort(runs.begin(), runs.end(), [](Points a, Points b) { return a.first < b.first; });
    std::vector<Points> fewer;
    for (const Points &run : runs) {
        if (!fewer.empty() && fewer.back().end() == run.first)
            fewer.back().count += run.count;
        else
            fewer.push_back(run);
    }
    return fewer;
}

}
