#include "sim/catalogue/scenes.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gust.h"
#include "sim/effects/drivers/turn_to_pointer.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/effects/tree/wind_torque.h"

namespace sim::hard {

using std::make_shared;

namespace {

constexpr double spread = 30.0; ///< degrees
constexpr Vec2 root = {275.0, 400.0};

TreeFormula formulaOf(const Values &values)
{
    return values.whole("formula") == 1 ? TreeFormula::published : TreeFormula::corrected;
}

TreePtr treeOf(const Values &values)
{
    return make_shared<const Tree>(
        forkedTree(values.whole("levels"), values["slope"], values["base_length"]));
}

/// All branches at rest, each at the end of its parent; they go only where they are turned to.
Scene standing(const Tree &tree, TreeFormula formula)
{
    const int branches = tree.branches();
    Scene scene;
    scene.start = State::ofPoints(branches);
    scene.start.angle = Eigen::Map<const Eigen::ArrayXd>(tree.rest.data(), branches);
    scene.start.place(0, root);
    fromTheTrunk(tree, scene.start, degreesOf(formula), [](int) {});
    for (int i = 0; i < branches; ++i)
        scene.names.push_back("branch" + std::to_string(i));
    scene.groups = {{SIM_TEXT("branches"), {0, branches}, Inertia::none}};
    return scene;
}

}

Tree forkedTree(int levels, double slope, double baseLength)
{
    Tree tree = Tree::ofTrunk(baseLength);
    for (int level = 0, first = 0; level < levels; ++level) {
        const int end = tree.branches();
        for (int i = first; i < end; ++i) {
            const auto row = static_cast<std::size_t>(i);
            const double angle = tree.rest[row], scale = slope * tree.scale[row];
            tree.sprout(i, angle - spread, scale);
            tree.sprout(i, angle + spread, scale);
        }
        first = end;
    }
    return tree;
}

Scene windyTree(const Values &values)
{
    const TreePtr tree = treeOf(values);
    const TreeFormula formula = formulaOf(values);
    Scene scene = standing(*tree, formula);
    scene.start.angle[0] += values["turned"];
    const auto by = static_cast<Resistance::By>(values.whole("by"));
    const Resistance resistance{by, by == Resistance::By::ease ? values["ease"] : values["wind"]};
    scene.effects = {make_shared<Joints>(tree, degreesOf(formula)),
                     make_shared<TreeWind>(tree, formula, resistance)};
    return scene;
}

Scene turningTree(const Values &values)
{
    const TreePtr tree = treeOf(values);
    Scene scene = standing(*tree, TreeFormula::corrected);
    scene.effects = {make_shared<Joints>(tree, degreesPerRadian),
                     make_shared<TurnToPointer>(tree, TreeFormula::corrected)};
    return scene;
}

Scene springyTree(const Values &values)
{
    const TreePtr tree = treeOf(values);
    Scene scene = standing(*tree, TreeFormula::corrected);
    scene.start.spin = Eigen::ArrayXd::Zero(tree->branches());
    scene.start.angle += values["bent"];
    scene.groups.front().inertia = Inertia::some;
    fromTheTrunk(*tree, scene.start, degreesPerRadian, [](int) {});
    const Limbs limbs = limbsOf(*tree, values["k"]);
    scene.effects = {make_shared<GustFront>(20.0), make_shared<Torsion>(tree, limbs),
                     make_shared<WindTorque>(tree, limbs.inertia, values["wind"], 0.5),
                     make_shared<SpinDamping>(values["damp"]), make_shared<Joints>(tree, degreesPerRadian)};
    return scene;
}

Scene grownTree(const Values &values)
{
    checkGrowth(values["slope"], values["min_scale"]);
    const double slope = values["slope"];
    const TreePtr tree = make_shared<const Tree>(
        forkedTree(static_cast<int>(std::log(values["min_scale"]) / std::log(slope)), slope, 100.0));
    Scene scene = standing(*tree, TreeFormula::corrected);
    scene.effects = {make_shared<Joints>(tree, degreesPerRadian)};
    return scene;
}

}
