#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/effect.h"
#include "sim/simd/dispatch.h"

#include <array>

namespace sim {

/// So many branches are computed in one go. With 128 a tree that fits no cache took a tenth to a third longer.
constexpr int maxBatch = 48;

/// One number for each branch of a run.
using BranchBuffer = std::array<double, maxBatch>;

/// Goes through a tree from the trunk to the twigs, several branches at once. The order of loops is that of
/// forEachFromTrunk(); each loop is short, so that a processor can begin with the next branches before it is done.
class TreeWalk
{
public:
    /// `degrees`: how many of them are a radian.
    TreeWalk(const Tree &tree, State &state, double degrees)
        : m_tree(tree), m_state(state), m_degrees(degrees)
    {
    }

    /// The branches after `run` that are computed together: none of them carries another. Empty at the end.
    PointRange next(PointRange range) const;
    /// Calls `use(branch, reach)` for each branch of `run`, several at once, with its reach at its angle in the state.
    template <class Use>
    void forEachReach(PointRange range, const Use &use) const
    {
        withReach(m_degrees, [&](const auto &reachOf) {
            dispatch([this, range, use, reachOf] {
                const double *angle = m_state.angle.data();
                const double length = m_tree.baseLength;
                const int end = range.end();
                SIM_TURNS_ARE_APART
                for (int i = range.first; i < end; ++i)
                    use(i, reachOf(angle[i], length));
            });
        });
    }
    /// Moves the children of `run` to where it ends. What a hand holds stays there.
    void moveChildren(PointRange range);

private:
    const Tree &m_tree;
    State &m_state;
    double m_degrees;
};

}
