#include "sim/catalogue/scenes.h"
#include "sim/effects/drivers/turn_to_pointer.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/scenes/trees.h"

namespace sim::hard {

using std::make_shared;

namespace {

TreeFormula formulaOf(const Values &values)
{
    return values.integer("formula") == 1 ? TreeFormula::published : TreeFormula::corrected;
}

TreePtr treeOf(const Values &values)
{
    return make_shared<const Tree>(
        scenes::forkedTree(values.integer("levels"), values["slope"], values["base_length"]));
}

}

Scene windyTree(const Values &values)
{
    const TreePtr tree = treeOf(values);
    const TreeFormula formula = formulaOf(values);
    Scene scene = scenes::standingTree(*tree, treeRoot, formula);
    scene.start.angle[0] += values["turned"];
    const auto by = static_cast<Resistance::By>(values.integer("by"));
    const Resistance resistance{by, by == Resistance::By::ease ? values["ease"] : values["wind"]};
    scene.effects = {make_shared<Joints>(tree, degreesOf(formula)),
                     make_shared<TreeWind>(tree, formula, resistance)};
    return scene;
}

Scene turningTree(const Values &values)
{
    const TreePtr tree = treeOf(values);
    Scene scene = scenes::standingTree(*tree, treeRoot, TreeFormula::corrected);
    scene.effects = {make_shared<Joints>(tree, degreesPerRadian),
                     make_shared<TurnToPointer>(tree, TreeFormula::corrected)};
    return scene;
}

Scene springyTree(const Values &values)
{
    const TreePtr tree = treeOf(values);
    Scene scene = scenes::standingTree(*tree, treeRoot, TreeFormula::corrected);
    scenes::enableSpins(scene);
    scene.start.angle += values["bent"];
    forEachFromTrunk(*tree, scene.start, degreesPerRadian, [](int) {});
    scenes::addSway(
        scene, tree,
        {.k = values["k"], .damp = values["damp"], .front = 20.0, .wind = values["wind"], .gusts = 0.5});
    return scene;
}

Scene grownTree(const Values &values)
{
    checkGrowth(values["slope"], values["min_scale"]);
    const double slope = values["slope"];
    const TreePtr tree = make_shared<const Tree>(
        scenes::forkedTree(static_cast<int>(std::log(values["min_scale"]) / std::log(slope)), slope, 100.0));
    Scene scene = scenes::standingTree(*tree, treeRoot, TreeFormula::corrected);
    scene.effects = {make_shared<Joints>(tree, degreesPerRadian)};
    return scene;
}

}
