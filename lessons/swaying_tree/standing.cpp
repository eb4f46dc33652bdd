#include "standing.h"

#include "sim/scenes/trees.h"

using namespace sim;

namespace swaying_tree {

TreeFormula formulaOf(const Values &values)
{
    return values.whole("formula") == 1 ? TreeFormula::published : TreeFormula::corrected;
}

Scene standing(const Tree &tree, TreeFormula formula)
{
    return scenes::standingTree(tree, {275.0, 400.0}, formula);
}

Scene swinging(const Tree &tree)
{
    Scene scene = standing(tree, TreeFormula::corrected);
    scenes::letSwing(scene);
    return scene;
}

}
