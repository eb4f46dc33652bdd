#pragma once

#include "sim/effect.h"
#include "sim/effects/tree.h"

#include <array>

namespace sim {

/// So many branches are computed in one go: what they come to fits the nearest cache.
constexpr int mostTogether = 128;

/// One number for each branch of a run.
using TreeRow = std::array<double, mostTogether>;

/// Goes through a tree from the trunk to the twigs, several branches at once. The order of loops is that of
/// fromTheTrunk(); each loop is short, so that a processor can begin with the next branches before it is done.
class TreeWalk
{
public:
    /// `degrees`: how many of them are a radian.
    TreeWalk(const Tree &tree, State &state, double degrees)
        : m_tree(tree), m_state(state), m_degrees(degrees)
    {
    }

    /// The branches after `run` that are computed together: none of them carries another. Empty at the end.
    Points next(Points run) const;
    /// Finds where `run` leads, at the angles that it has in the state.
    void findReach(Points run);
    /// Moves the children of `run` to where it ends. What a hand holds stays there.
    void carry(Points run);

    /// px: what findReach() has found, by the place in the run.
    const TreeRow &reachX() const { return m_reachX; }
    const TreeRow &reachY() const { return m_reachY; }

private:
    const Tree &m_tree;
    State &m_state;
    double m_degrees;
    // These begin without values: whatever is read has been written before.
    TreeRow m_reachX;
    TreeRow m_reachY;
};

}
