#pragma once

#include "sim/direction.h"
#include "sim/effects/tree.h"
#include "sim/free_points.h"

#include <array>
#include <cstdint>
#include <limits>

namespace sim {

/// So many branches are computed in one go: what they come to fits the nearest cache.
constexpr int mostTogether = 128;

/// The branches from `first` on that are computed together: none of them carries another.
Points branchesTogether(const Tree &tree, int first);

/// A turned branch.
struct TurnedBranch
{
    double angle = 0.0; ///< degrees
    /// px: how long the distance is whose direction was found; below inOnePlace that needs a rule.
    double distance = std::numeric_limits<double>::infinity();
};

/// What walks through a tree share.
struct TreeWalk
{
    const Tree &tree;
    State &state;
    double degrees; ///< how many of them are a radian
    std::array<double, mostTogether> angle{};
    std::array<double, mostTogether> endX{}; ///< px
    std::array<double, mostTogether> endY{};

    /// Moves the children of `branches` to their ends, at the angles that these have in the state.
    void carry(Points branches);
};

/// Goes through a tree from the trunk to the twigs, several branches at once: turns each that feels anything, when it
/// stands where it belongs, to what `turn(i, origin, angle)` says, a TurnedBranch, or, where that needs
/// a rule, `carefully(i)`, an angle; then moves its children to its end. A branch in a hand stays where the hand is.
template <class Turn, class Carefully>
void fromTheTrunkTogether(const Tree &tree, State &state, double degrees, const Turn &turn,
                          const Carefully &carefully)
{
    TreeWalk walk{tree, state, degrees};
    for (Points run{0, 0}; run.end() < tree.branches();) {
        run = branchesTogether(tree, run.end());
        std::int64_t close = 0;
        runFast([&] {
            const Turn one = turn; // numbers that no store can change
            const double *x = state.position.data(), *y = x + state.position.rows();
            const double *old = state.angle.data();
            double *angle = walk.angle.data();
            std::int64_t any = 0;
            const int first = run.first, count = run.count;
            SIM_TURNS_ARE_APART
            for (int i = 0; i < count; ++i) {
                const int branch = first + i;
                const TurnedBranch turned = one(branch, Vec2{x[branch], y[branch]}, old[branch]);
                angle[i] = turned.angle;
                any |= turned.distance >= inOnePlace ? std::int64_t{0} : std::int64_t{1};
            }
            close = any;
        });
        for (int i = 0; close != 0 && i < run.count; ++i)
            walk.angle[static_cast<std::size_t>(i)] = carefully(run.first + i);
        replaceFree(state.inverseMass, run, state.angle.data(),
                    [angle = walk.angle.data(), first = run.first](int i) { return angle[i - first]; });
        walk.carry(run);
    }
}

/// Moves each branch to the end of its parent.
void carryAll(const Tree &tree, State &state, double degrees);

}
