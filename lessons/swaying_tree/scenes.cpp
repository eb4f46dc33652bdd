#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/base/random.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gust.h"
#include "sim/effects/drivers/turn_to_pointer.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/return_to_rest.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/effects/tree/wind_torque.h"
#include "sim/scenes/trees.h"

using namespace sim;
using lessons::add;

namespace swaying_tree {

TreeFormula formulaOf(const Values &values)
{
    return values.integer("formula") == 1 ? TreeFormula::published : TreeFormula::corrected;
}

Scene standing(const Tree &tree, TreeFormula formula)
{
    return scenes::standingTree(tree, {275.0, 400.0}, formula);
}

Scene swinging(const Tree &tree)
{
    Scene scene = standing(tree, TreeFormula::corrected);
    scenes::enableSpins(scene);
    return scene;
}

// Learners read the functions below in a narrow panel.
// clang-format off

namespace trunk {

//! [trunk]
Tree grow(const Values &values)
{
    // one branch, straight up: -90
    double length = values["base_length"];
    Tree tree = Tree::ofTrunk(length);
    return tree;
}

Scene setUp(const Values &values)
{
    TreePtr tree = shared(grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);
    return scene;
}
//! [trunk]

}

namespace branches {

//! [branches]
Tree grow(const Values &values)
{
    double length = values["base_length"];
    double spread = values["spread"];
    double slope = values["slope"];
    double minScale = values["min_scale"];
    // refuses a tree without an end
    checkGrowth(slope, minScale);

    Tree tree = Tree::ofTrunk(length);
    for (int i = 0; i < tree.branchCount(); ++i) {
        double scale = slope * tree.scaleOf(i);
        if (scale > minScale) {
            double angle = tree.restOf(i);
            double left = angle - spread;
            double right = angle + spread;
            tree.addBranch(i, left, scale);
            tree.addBranch(i, right, scale);
        }
    }
    return tree;
}

Scene setUp(const Values &values)
{
    TreePtr tree = shared(grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);
    return scene;
}
//! [branches]

}

namespace randomness {

//! [randomness]
Tree grow(const Values &values)
{
    double length = values["base_length"];
    double spread = values["spread"];
    double slope = values["slope"];
    double minScale = values["min_scale"];
    // refuses a tree without an end
    checkGrowth(slope, minScale);

    double jitter = values["jitter"];
    auto some = [&](int branch) {
        double random =
            uniform(values.seed, 0, branch);
        return jitter * (2 * random - 1);
    };
    Tree tree = Tree::ofTrunk(length);
    for (int i = 0; i < tree.branchCount(); ++i) {
        double scale = slope * tree.scaleOf(i);
        if (scale > minScale) {
            double angle = tree.restOf(i);
            int n = tree.branchCount();
            double left =
                angle - spread + some(n);
            double right =
                angle + spread + some(n + 1);
            tree.addBranch(i, left, scale);
            tree.addBranch(i, right, scale);
        }
    }
    return tree;
}

Scene setUp(const Values &values)
{
    TreePtr tree = shared(grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);
    return scene;
}
//! [randomness]

}

namespace towards_pointer {

//! [towards_pointer]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);

    // while the button is down
    add<TurnToPointer>(scene, tree, formula);
    return scene;
}
//! [towards_pointer]

}

namespace wind {

//! [wind]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);

    Resistance resistance;
    resistance.by = Resistance::By::ease;
    resistance.amount = values["ease"];
    add<TreeWind>(scene, tree, formula,
        resistance);
    return scene;
}
//! [wind]

}

namespace rest {

//! [rest]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double ease = values["ease"];
    add<ReturnToRest>(scene, tree, ease);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);

    Resistance resistance;
    resistance.by = Resistance::By::ease;
    resistance.amount = values["ease"];
    add<TreeWind>(scene, tree, formula,
        resistance);
    return scene;
}
//! [rest]

}

namespace distance {

//! [distance]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double ease = values["ease"];
    add<ReturnToRest>(scene, tree, ease);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);

    Resistance resistance;
    resistance.by = Resistance::By::distance;
    add<TreeWind>(scene, tree, formula,
        resistance);
    return scene;
}
//! [distance]

}

namespace thickness {

//! [thickness]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double ease = values["ease"];
    add<ReturnToRest>(scene, tree, ease);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);

    Resistance resistance;
    resistance.by = Resistance::By::thickness;
    resistance.amount = values["wind"];
    add<TreeWind>(scene, tree, formula,
        resistance);
    return scene;
}
//! [thickness]

}

namespace turbulence {

//! [turbulence]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    auto formula = formulaOf(values);
    Scene scene = standing(*tree, formula);

    double ease = values["ease"];
    add<ReturnToRest>(scene, tree, ease);

    double degrees = degreesOf(formula);
    add<Joints>(scene, tree, degrees);

    Resistance resistance;
    resistance.by = Resistance::By::thickness;
    resistance.amount = values["wind"];
    Turbulence turbulence;
    turbulence.degrees = values["turbulence"];
    turbulence.seed = values.seed;
    add<TreeWind>(scene, tree, formula,
        resistance, turbulence);
    return scene;
}
//! [turbulence]

}

namespace real_sway {

//! [real_sway]
Scene setUp(const Values &values)
{
    TreePtr tree =
        shared(randomness::grow(values));
    Scene scene = swinging(*tree);

    // first: the gust runs on
    double speed = values["gust_speed"];
    add<GustFront>(scene, speed);

    // springs that turn, in every joint
    double k = values["k"];
    BranchMechanics limbs = branchMechanicsOf(*tree, k);
    add<Torsion>(scene, tree, limbs);

    double wind = values["wind"];
    double gusts = values["gusts"];
    add<WindTorque>(scene, tree,
        limbs.inertia, wind, gusts);

    double damp = values["damp"];
    add<SpinDamping>(scene, damp);

    // last: children go to their parents
    add<Joints>(scene, tree, degreesPerRadian);
    return scene;
}
//! [real_sway]

}

}
