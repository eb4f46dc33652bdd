#include "sim/effects/tree/tree_walk.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>

namespace sim {

Points TreeWalk::next(Points run) const
{
    const int first = run.end(), most = std::min(first + mostTogether, m_tree.branches());
    for (int i = first; i < std::min(most, m_tree.carriers); ++i) {
        // children of later branches come after those of earlier ones
        if (const int child = m_tree.firstChild[static_cast<std::size_t>(i)]; child >= 0)
            return {first, std::min(child, most) - first};
    }
    return {first, most - first};
}

void TreeWalk::carry(Points run)
{
    run = common(run, {0, m_tree.carriers});
    const auto carries = [this](int i) { return m_tree.firstChild[static_cast<std::size_t>(i)] >= 0; };
    while (run.count > 0 && !carries(run.end() - 1))
        --run.count;
    if (run.count == 0)
        return;
    int first = run.first;
    while (!carries(first))
        ++first;
    const auto last = static_cast<std::size_t>(run.end() - 1);
    const int from = m_tree.firstChild[static_cast<std::size_t>(first)];
    const Points children = {from, m_tree.firstChild[last] + m_tree.children[last] - from};
    TreeRow endX, endY; // each number is written before it is read
    const Columns at(m_state.position);
    forEachReach(run, [at, first = run.first, scale = m_tree.scale.data(), x = endX.data(),
                       y = endY.data()](int i, Vec2 reach) {
        const Vec2 end = branchEnd(at.at(i), reach, scale[i]);
        x[i - first] = end.x;
        y[i - first] = end.y;
    });
    replaceFree(
        m_state.inverseMass, children, m_state.position,
        [first = run.first, parent = m_tree.parent.data(), x = endX.data(), y = endY.data()](int child) {
            const int i = parent[child] - first;
            return Vec2{x[i], y[i]};
        });
}

}
