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
    tree.addBranch(-1, -90.0, 1.0);
    return tree;
}

void Tree::addBranch(int from, double angle, double branchScale)
{
    const int branch = branchCount();
    parent.push_back(from);
    firstChild.push_back(-1);
    children.push_back(0);
    rest.push_back(angle);
    scale.push_back(branchScale);
    if (from < 0)
        return;
    const auto index = static_cast<std::size_t>(from);
    if (firstChild[index] < 0)
        firstChild[index] = branch;
    ++children[index];
    firstTwig = from + 1;
}

void Tree::addCouplings(std::vector<std::pair<int, int>> &couplings) const
{
    for (int i = 0; i < branchCount(); ++i) {
        if (const int from = parent[static_cast<std::size_t>(i)]; from >= 0)
            couplings.emplace_back(i, from);
    }
}

void checkGrowth(double slope, double minScale)
{
    long branches = 1, level = 1;
    for (double scale = slope; scale > minScale; scale *= slope) {
        level *= 2;
        branches += level;
        if (branches > maxBranches)
            throw Error("tree-too-big",
                        {{"most", text(maxBranches)}, {"slope", text(slope)}, {"min_scale", text(minScale)}});
    }
}

}
