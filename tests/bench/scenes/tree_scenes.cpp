#include "tests/bench/scenes/tree_scenes.h"

#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/return_to_rest.h"
#include "sim/scenes/trees.h"

namespace bench::trees {

namespace {

/// Returns a scene of the branches of `tree`, with wind.
sim::Scene sceneOf(const sim::Tree &tree)
{
    sim::Scene scene = scenes::branchesOf(tree);
    scene.start.place(0, foot);
    scene.start.input.pointer = pointer;
    scene.start.input.pointerDown = true;
    return scene;
}

}

sim::TreePtr full(int forks)
{
    return std::make_shared<const sim::Tree>(scenes::forkedTree(forks, 0.9, 100.0));
}

sim::Scene inTheWind(const sim::TreePtr &tree, sim::TreeFormula formula)
{
    sim::Scene scene = sceneOf(*tree);
    const sim::Resistance resistance{sim::Resistance::By::thickness, wind};
    scene.effects = {
        std::make_shared<const sim::ReturnToRest>(tree, ease),
        std::make_shared<const sim::Joints>(tree, sim::degreesOf(formula)),
        std::make_shared<const sim::TreeWind>(tree, formula, resistance, sim::Turbulence{turbulence, seed})};
    return scene;
}

sim::Scene thatSwings(const sim::TreePtr &tree)
{
    sim::Scene scene = sceneOf(*tree);
    scenes::enableSpins(scene);
    scenes::addSway(scene, tree, {.k = 0.05, .damp = 0.96, .front = 12.0, .wind = 5.0, .gusts = 0.6});
    return scene;
}

}
