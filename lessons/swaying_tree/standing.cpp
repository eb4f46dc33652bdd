#include "standing.h"

#include <string>

using namespace sim;

namespace swaying_tree {

TreeFormula formulaOf(const Values &values)
{
    return values.whole("formula") == 1 ? TreeFormula::published : TreeFormula::corrected;
}

Scene standing(const Tree &tree, TreeFormula formula)
{
    const int branches = tree.branches();
    Scene scene;
    scene.start = State::ofPoints(branches);
    scene.start.angle = Eigen::Map<const Eigen::ArrayXd>(tree.rest.data(), branches);
    scene.start.place(0, {275.0, 400.0});
    fromTheTrunk(tree, scene.start, degreesOf(formula), [](int) {});
    scene.names.reserve(tree.parent.size());
    for (int i = 0; i < branches; ++i)
        scene.names.push_back(SIM_TEXT("branch") + std::to_string(i));
    scene.groups = {{SIM_TEXT("branches"), {0, branches}, Inertia::none}};
    return scene;
}

Scene swinging(const Tree &tree)
{
    Scene scene = standing(tree, TreeFormula::corrected);
    scene.start.spin = Eigen::ArrayXd::Zero(tree.branches());
    scene.groups.front().inertia = Inertia::some;
    return scene;
}

}
