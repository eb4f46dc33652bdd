#include "sim/effects/tree/tree.h"

#include "sim/base/error.h"

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
    carriers = from + 1;
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

}
