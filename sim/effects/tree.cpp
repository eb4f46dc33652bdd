#include "sim/effects/tree.h"

#include "sim/effects/tree_walk.h"

#include "sim/error.h"

#include <algorithm>
#include <sstream>

namespace sim {

namespace {

std::string text(double value)
{
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

}

Tree Tree::ofTrunk(double baseLength)
{
    Tree tree;
    tree.baseLength = baseLength;
    tree.sprout(-1, -90.0, 1.0);
    return tree;
}

void Tree::sprout(int from, double angle, double branchScale)
{
    const int number = branches();
    parent.push_back(from);
    firstChild.push_back(-1);
    children.push_back(0);
    rest.push_back(angle);
    scale.push_back(branchScale);
    if (from < 0)
        return;
    const auto row = static_cast<std::size_t>(from);
    if (firstChild[row] < 0)
        firstChild[row] = number;
    ++children[row];
}

void Tree::ties(std::vector<std::pair<int, int>> &into) const
{
    for (int i = 0; i < branches(); ++i) {
        if (const int from = parent[static_cast<std::size_t>(i)]; from >= 0)
            into.emplace_back(i, from);
    }
}

void checkGrowth(double slope, double minScale)
{
    long branches = 1, level = 1;
    for (double scale = slope; scale > minScale; scale *= slope) {
        level *= 2;
        branches += level;
        if (branches > mostBranches)
            throw Error(
                "tree-too-big",
                {{"most", text(mostBranches)}, {"slope", text(slope)}, {"min_scale", text(minScale)}});
    }
}

Points branchesTogether(const Tree &tree, int first)
{
    const int most = std::min(first + mostTogether, tree.branches());
    for (int i = first; i < most; ++i) {
        // children of later branches come after those of earlier ones
        if (const int child = tree.firstChild[static_cast<std::size_t>(i)]; child >= 0)
            return {first, std::min(child, most) - first};
    }
    return {first, most - first};
}

void TreeWalk::carry(Points branches)
{
    const auto isTwig = [this](int i) { return tree.firstChild[static_cast<std::size_t>(i)] < 0; };
    while (branches.count > 0 && isTwig(branches.end() - 1))
        --branches.count;
    runFast([this, branches] {
        const double *x = state.position.data(), *y = x + state.position.rows();
        const double *turned = state.angle.data(), *scale = tree.scale.data();
        double *toX = endX.data(), *toY = endY.data();
        const double length = tree.baseLength, unit = degrees;
        const int first = branches.first, count = branches.count;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            const int branch = first + i;
            const Vec2 reach = branchReach(turned[branch], length, unit);
            const Vec2 end = branchEnd({x[branch], y[branch]}, reach, scale[branch]);
            toX[i] = end.x;
            toY[i] = end.y;
        }
    });
    Columns place(state.position);
    for (int i = 0; i < branches.count; ++i) {
        const auto row = static_cast<std::size_t>(branches.first + i);
        const int first = tree.firstChild[row], end = first + tree.children[row];
        for (int child = first; child < end; ++child) {
            if (!state.feels(child))
                continue;
            place.x[child] = endX[static_cast<std::size_t>(i)];
            place.y[child] = endY[static_cast<std::size_t>(i)];
        }
    }
}

void carryAll(const Tree &tree, State &state, double degrees)
{
    TreeWalk walk{tree, state, degrees};
    for (Points run{0, 0}; run.end() < tree.branches();) {
        run = branchesTogether(tree, run.end());
        walk.carry(run);
    }
}

}
