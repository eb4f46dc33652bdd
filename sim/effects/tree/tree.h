#pragma once

#include "sim/scene/state.h"
#include "sim/simd/portable_math.h"

#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace sim {

/// A tree of straight branches, breadth first: the trunk is number 0, parents come before their children, and the
/// children of one branch follow each other. One entry a branch.
struct Tree
{
    std::vector<int> parent;     ///< -1 for the trunk
    std::vector<int> firstChild; ///< -1 for a twig, which has none
    std::vector<int> children;   ///< how many
    std::vector<double> rest;    ///< degrees, clockwise from the x axis; -90 is straight up
    std::vector<double> scale;   ///< length and thickness as a share of the trunk's
    int firstTwig = 0;           ///< all branches from this one on are twigs
    double baseLength = 100.0;   ///< px, of a branch of scale 1

    /// A trunk that stands straight up, of scale 1.
    static Tree ofTrunk(double baseLength);
    /// Adds a branch at the end of branch `from`. All children of a branch are added before those of the next.
    void addBranch(int from, double angle, double branchScale);
    int branchCount() const { return static_cast<int>(parent.size()); }
    /// Each branch with the one that it grows from.
    void addCouplings(std::vector<std::pair<int, int>> &into) const;
};

using TreePtr = std::shared_ptr<const Tree>;

/// No tree that grows by numbers which a learner sets has more branches than this: 2^17 - 1, which is 17 levels that
/// double. It bounds time and memory; a tree that is built in code can be as large as these allow.
constexpr int maxBranches = 131'071;

/// Refuses a tree in which each branch has two children, `slope` times as large, as long as they are larger than
/// `minScale`, before it is grown.
/// @throws Error "tree-too-big" (most, slope, min_scale) when it has more than maxBranches, or no end
void checkGrowth(double slope, double minScale);

/// Degrees to the radian, and the number that the tutorial uses for it.
constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
constexpr double publishedDegrees = 57.3;

/// Which formulas bend a tree.
enum class TreeFormula {
    corrected, ///< what the tutorial's text means
    published, ///< what its code prints: 57.3 degrees to the radian, the end point added, 360 for 180
};

constexpr double degreesOf(TreeFormula formula)
{
    return formula == TreeFormula::published ? publishedDegrees : degreesPerRadian;
}

/// Formulas of trees, with the functions of alike.h.
namespace tree_formulas {

using portable::atan2;
using portable::remainder;

/// The way from a branch's origin to its end before the branch is scaled: px. Angle in degrees; `degrees` are how
/// many of them are a radian. Published: swaying tree, getEndPoint().
// Shown lines are short.
// clang-format off
template <class Cos, class Sin>
//! [reach]
Vec2 branchReach(
    double angle, double length,
    double degrees, Cos cos, Sin sin)
{
    double rad = angle / degrees;
    Vec2 reach = {length * cos(rad),
                  length * sin(rad)};
    return reach;
}
//! [reach]
// clang-format on

}

/// Calls `work` with a function that computes the reach of a branch from its angle and length, for so many `degrees` to
/// the radian. The published number goes with alike::cos() and alike::sin(), which published runs have their bits from.
template <class Work>
auto withReach(double degrees, const Work &work)
{
    if (degrees == publishedDegrees)
        return work([](double angle, double length) {
            return tree_formulas::branchReach(angle, length, publishedDegrees, portable::cos, portable::sin);
        });
    return work([degrees](double angle, double length) {
        return tree_formulas::branchReach(angle, length, degrees, portable::fast::cos, portable::fast::sin);
    });
}

inline Vec2 branchReach(double angle, double length, double degrees)
{
    return withReach(degrees, [&](const auto &reachOf) { return reachOf(angle, length); });
}

/// Where a branch ends, px: there its children begin. Published: swaying tree, localToGlobal(endPoint).
// Shown lines are short.
// clang-format off
inline
//! [end]
Vec2 branchEnd(
    Vec2 origin, Vec2 reach,
    double scale)
{
    Vec2 end = origin + scale * reach;
    return end;
}
//! [end]
// clang-format on

/// What a branch sees of the pointer.
struct PointerOffset
{
    Vec2 mouse; ///< the pointer in the branch's frame, in px of a branch of scale 1
    Vec2 d;     ///< to the pointer, as the formula has it; likewise
};

/// The pointer as the published code has it: in the frame of the branch, which is scaled but not turned. The end
/// point is added where the text means the distance between the two.
/// Published: swaying tree, mouseX + endPoint.x.
// Shown lines are short.
// clang-format off
inline
//! [sight_published]
PointerOffset pointerOffsetPublished(
    Vec2 pointer, Vec2 origin,
    Vec2 reach, double scale)
{
    // in the branch's own frame
    Vec2 mouse = {
        (pointer.x - origin.x) / scale,
        (pointer.y - origin.y) / scale};
    // printed with a plus
    Vec2 d = mouse + reach;
    return {mouse, d};
}
//! [sight_published]
// clang-format on

/// Where branch `i` ends in `state`.
inline Vec2 endOf(const Tree &tree, const State &state, int i, double degrees)
{
    const Vec2 reach = branchReach(state.angle[i], tree.baseLength, degrees);
    return branchEnd(state.positionOf(i), reach, tree.scale[static_cast<std::size_t>(i)]);
}

/// Goes through the tree from the trunk to the twigs: calls `turn(i)` for each branch that feels anything, when it
/// stands where it belongs, then moves its children to its end. A branch in a hand stays where the hand is.
/// TreeWalk does it for many.
template <class Turn>
void forEachFromTrunk(const Tree &tree, State &state, double degrees, Turn &&turn)
{
    for (int i = 0; i < tree.branchCount(); ++i) {
        if (state.isDynamic(i))
            turn(i);
        const int first = tree.firstChild[static_cast<std::size_t>(i)];
        if (first < 0)
            continue;
        const Vec2 end = endOf(tree, state, i, degrees);
        for (int child = first; child < first + tree.children[static_cast<std::size_t>(i)]; ++child) {
            if (state.isDynamic(child))
                state.place(child, end);
        }
    }
}

}
