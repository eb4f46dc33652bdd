#pragma once

#include "sim/scene/state.h"
#include "sim/simd/portable_math.h"

#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace sim {

/// A tree of straight branches in breadth-first order. The trunk is branch 0, parents come before their
/// children, and siblings are neighbours. A twig is a branch without children. One entry per branch.
struct Tree
{
    std::vector<int> parent;     ///< index of the parent; -1 for the trunk
    std::vector<int> firstChild; ///< index of the first child; -1 for a twig
    std::vector<int> children;   ///< number of children
    std::vector<double> rest;    ///< degrees, rest angle, clockwise from the x axis; -90 is straight up
    std::vector<double> scale;   ///< length and thickness as a fraction of the trunk's
    int firstTwig = 0;           ///< index from which on all branches are twigs
    double baseLength = 100.0;   ///< px, length of a branch of scale 1

    /// Returns a tree that consists of an upright trunk of scale 1. `baseLength` in px.
    static Tree ofTrunk(double baseLength);
    /// Adds a branch at the end of branch `from`, at the rest angle `angle` (degrees). All children of a
    /// branch have to be added before those of the next branch.
    void addBranch(int from, double angle, double branchScale);
    double restOf(int branch) const { return rest[static_cast<std::size_t>(branch)]; }
    double scaleOf(int branch) const { return scale[static_cast<std::size_t>(branch)]; }
    int branchCount() const { return static_cast<int>(parent.size()); }
    /// Adds the pairs (branch, parent).
    void addCouplings(std::vector<std::pair<int, int>> &couplings) const;
};

using TreePtr = std::shared_ptr<const Tree>;

/// The largest tree that a learner's parameters can grow: 2^17 - 1 branches, which is 17 levels that double.
/// It limits time and memory. Trees that are built in code have no such limit.
constexpr int maxBranches = 131'071;

/// Checks the size of a tree before it is grown. Each branch has two children that are `slope` times as
/// large, as long as these are larger than `minScale`.
/// @throws Error "tree-too-big" (most, slope, min_scale) if the tree has more than maxBranches branches or
/// grows without end
void checkGrowth(double slope, double minScale);

/// Number of degrees per radian.
constexpr double degreesPerRadian = 180.0 / std::numbers::pi;
/// The rounded number that the tutorial uses instead.
constexpr double publishedDegrees = 57.3;

/// Which formulas move a tree.
enum class TreeFormula {
    corrected, ///< what the tutorial's text describes
    published, ///< the tutorial's code: 57.3 degrees per radian, the end point added, 360 instead of 180
};

/// Returns the number of degrees per radian that `formula` uses.
constexpr double degreesOf(TreeFormula formula)
{
    return formula == TreeFormula::published ? publishedDegrees : degreesPerRadian;
}

/// Formulas of trees. They use portable mathematics, so all machines compute the same bits.
namespace tree_formulas {

using portable::atan2;
using portable::remainder;

/// Returns the vector (px) from the origin of a branch to its end, for a branch of scale 1. `angle`:
/// degrees. `degrees`: number of degrees per radian. Published: swaying tree, getEndPoint().
// Shown lines are short.
// clang-format off
template <class Cos, class Sin>
SIM_INLINED inline
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

/// Calls `work` with a function that returns the reach of a branch for an angle (degrees) and a length (px).
/// `degrees`: number of degrees per radian. For the published number, the function uses portable::cos() and
/// portable::sin() instead of the fast ones, because they determine the bits of published runs.
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

/// Returns the reach of a branch; see tree_formulas::branchReach().
inline Vec2 branchReach(double angle, double length, double degrees)
{
    return withReach(degrees, [&](const auto &reachOf) { return reachOf(angle, length); });
}

/// Returns the position of the end of a branch, in px. Its children begin there.
/// Published: swaying tree, localToGlobal(endPoint).
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

/// Stands for the pointer in direction() and fallbackDirection(), as the pointer is not one of the points.
constexpr int pointerIndex = -1;

/// The pointer as a branch sees it.
struct PointerOffset
{
    Vec2 mouse; ///< position of the pointer in the branch's frame, in px of a branch of scale 1
    Vec2 d;     ///< vector to the pointer by the published formula, in the same unit
};

/// Returns the pointer in the frame of a branch, by the published formula. The frame is scaled but not
/// rotated. The code adds the end point, although the text describes the difference of the two points.
/// Published: swaying tree, mouseX + endPoint.x.
// Shown lines are short.
// clang-format off
inline
//! [pointer_offset_published]
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
//! [pointer_offset_published]
// clang-format on

/// Returns the position (px) of the end of branch `i` in `state`.
inline Vec2 endOf(const Tree &tree, const State &state, int i, double degrees)
{
    const Vec2 reach = branchReach(state.angle[i], tree.baseLength, degrees);
    return branchEnd(state.positionOf(i), reach, tree.scaleOf(i));
}

/// Visits the branches from the trunk to the twigs. For each dynamic branch calls `turn(i)`, after the branch
/// was moved to the end of its parent. Then moves its children to its end. A dragged branch stays at the
/// hand. TreeWalk does the same for many branches at once.
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
