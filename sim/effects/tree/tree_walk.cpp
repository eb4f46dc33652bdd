#include "sim/effects/tree/tree_walk.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

PointRange TreeWalk::next(PointRange range) const
{
    const int first = range.end(), end = std::min(first + maxBatch, m_tree.branchCount());
    for (int i = first; i < std::min(end, m_tree.firstTwig); ++i) {
        // Breadth-first order: no other branch of the batch has a child with a smaller index.
        if (const int child = m_tree.firstChild[static_cast<std::size_t>(i)]; child >= 0)
            return {first, std::min(child, end) - first};
    }
    return {first, end - first};
}

void TreeWalk::moveChildren(PointRange range)
{
    range = intersection(range, {0, m_tree.firstTwig});
    const auto hasChildren = [this](int i) { return m_tree.firstChild[static_cast<std::size_t>(i)] >= 0; };
    while (range.count > 0 && !hasChildren(range.end() - 1))
        --range.count;
    if (range.count == 0)
        return;
    int first = range.first;
    while (!hasChildren(first))
        ++first;
    const auto last = static_cast<std::size_t>(range.end() - 1);
    const int firstChild = m_tree.firstChild[static_cast<std::size_t>(first)];
    const PointRange children = {firstChild, m_tree.firstChild[last] + m_tree.children[last] - firstChild};
    BranchBuffer endX, endY; // uninitialised: each number is written before it is read
    const XyColumns position(m_state.position);
    forEachReach(range, [position, first = range.first, scale = m_tree.scale.data(), x = endX.data(),
                         y = endY.data()](int i, Vec2 reach) {
        const Vec2 end = branchEnd(position.at(i), reach, scale[i]);
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
