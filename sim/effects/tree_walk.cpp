#include "sim/effects/tree_walk.h"

#include "sim/free_points.h"

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

void TreeWalk::findReach(Points run)
{
    runFast([this, run] {
        const double *angle = m_state.angle.data() + run.first;
        double *x = m_reachX.data(), *y = m_reachY.data();
        const double length = m_tree.baseLength, degrees = m_degrees;
        const int count = run.count;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            const Vec2 reach = branchReach(angle[i], length, degrees);
            x[i] = reach.x;
            y[i] = reach.y;
        }
    });
}

void TreeWalk::carry(Points run)
{
    run = common(run, {0, m_tree.carriers});
    const auto carries = [this](int i) { return m_tree.firstChild[static_cast<std::size_t>(i)] >= 0; };
    while (run.count > 0 && !carries(run.end() - 1))
        --run.count;
    if (run.count == 0)
        return;
    findReach(run);
    int first = run.first;
    while (!carries(first))
        ++first;
    const auto last = static_cast<std::size_t>(run.end() - 1);
    const int from = m_tree.firstChild[static_cast<std::size_t>(first)];
    const Points children = {from, m_tree.firstChild[last] + m_tree.children[last] - from};
    const int *parent = m_tree.parent.data();
    const double *scale = m_tree.scale.data(), *x = m_reachX.data(), *y = m_reachY.data();
    replaceFree(m_state.inverseMass, children, m_state.position,
                [=, at = Columns(m_state.position), begin = run.first](int child) {
                    const int i = parent[child];
                    return branchEnd(at.at(i), {x[i - begin], y[i - begin]}, scale[i]);
                });
}

}
