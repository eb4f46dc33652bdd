#include "sim/effects/tree/tree_walk.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

PointRange TreeWalk::next(PointRange range) const
{
    const int first = range.end(), most = std::min(first + maxBatch, m_tree.branchCount());
    for (int i = first; i < std::min(most, m_tree.firstTwig); ++i) {
        // children of later branches come after those of earlier ones
        if (const int child = m_tree.firstChild[static_cast<std::size_t>(i)]; child >= 0)
            return {first, std::min(child, most) - first};
    }
    return {first, most - first};
}

void TreeWalk::moveChildren(PointRange range)
{
    range = intersection(range, {0, m_tree.firstTwig});
    const auto carries = [this](int i) { return m_tree.firstChild[static_cast<std::size_t>(i)] >= 0; };
    while (range.count > 0 && !carries(range.end() - 1))
        --range.count;
    if (range.count == 0)
        return;
    int first = range.first;
    while (!carries(first))
        ++first;
    const auto last = static_cast<std::size_t>(range.end() - 1);
    const int from = m_tree.firstChild[static_cast<std::size_t>(first)];
    const PointRange children = {from, m_tree.firstChild[last] + m_tree.children[last] - from};
    BranchBuffer endX, endY; // each number is written before it is read
    const XyColumns at(m_state.position);
    forEachReach(range, [at, first = range.first, scale = m_tree.scale.data(), x = endX.data(),
                         y = endY.data()](int i, Vec2 reach) {
        const Vec2 end = branchEnd(at.at(i), reach, scale[i]);
        x[i - first] = end.x;
        y[i - first] = end.y;
    });
    updateDynamic(
        m_state.inverseMass, children, m_state.position,
        [first = range.first, parent = m_tree.parent.data(), x = endX.data(), y = endY.data()](int child) {
            const int i = parent[child] - first;
            return Vec2{x[i], y[i]};
        });
}

}
