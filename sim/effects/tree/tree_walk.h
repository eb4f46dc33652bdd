#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/effect.h"
#include "sim/simd/dispatch.h"

#include <array>

namespace sim {

/// Maximum number of branches in a batch. With 128, a tree too large for the cache took a tenth to a third
/// longer.
constexpr int maxBatch = 48;

/// One number for each branch of a batch.
using BranchBuffer = std::array<double, maxBatch>;

/// Visits the branches of a tree from the trunk to the twigs in batches, with the same result as
/// forEachFromTrunk(). The loops are short, so the processor can start the next batch before one is complete.
class TreeWalk
{
public:
    /// `degrees`: number of degrees per radian.
    TreeWalk(const Tree &tree, State &state, double degrees)
        : m_tree(tree), m_state(state), m_degrees(degrees)
    {
    }

    /// Returns the batch of branches after `range`: no branch is the parent of another one. Empty at the end.
    PointRange next(PointRange range) const;
    /// Calls `use(branch, reach)` for each branch of `range`, in a vectorised loop; see branchReach().
    template <class Use>
    void forEachReach(PointRange range, const Use &use) const
    {
        withReach(m_degrees, [&](const auto &reachOf) {
            dispatch([this, range, use, reachOf] {
                const double *angle = m_state.angle.data();
                const double length = m_tree.baseLength;
                const int end = range.end();
                SIM_INDEPENDENT_ITERATIONS
                for (int i = range.first; i < end; ++i)
                    use(i, reachOf(angle[i], length));
            });
        });
    }
    /// Moves the dynamic children of the branches of `range` to the ends of their parents.
    void moveChildren(PointRange range);

private:
    const Tree &m_tree;
    State &m_state;
    double m_degrees;
};

}
