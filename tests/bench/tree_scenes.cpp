#include "tree_scenes.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gust.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/return_to_rest.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/wind_torque.h"

namespace bench::trees {

namespace {

sim::Scene sceneOf(const sim::Tree &tree, sim::Inertia inertia)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(tree.branches());
    scene.start.angle = Eigen::Map<const Eigen::ArrayXd>(tree.rest.data(), tree.branches());
    scene.start.place(0, foot);
    scene.start.outside.pointer = pointer;
    scene.start.outside.pointerDown = true;
    scene.groups = {{"branches", {0, tree.branches()}, inertia}};
    scene.names.reserve(tree.rest.size());
    for (int i = 0; i < tree.branches(); ++i)
        scene.names.push_back("branch" + std::to_string(i));
    return scene;
}

}

sim::TreePtr full(int forks)
{
    sim::Tree tree = sim::Tree::ofTrunk(100.0);
    const int parents = (1 << forks) - 1;
    for (int i = 0; i < parents; ++i) {
        const auto row = static_cast<std::size_t>(i);
        const double angle = tree.rest[row], scale = 0.9 * tree.scale[row];
        tree.sprout(i, angle - 30.0, scale);
        tree.sprout(i, angle + 30.0, scale);
    }
    return std::make_shared<const sim::Tree>(std::move(tree));
}

sim::Scene inTheWind(const sim::TreePtr &tree, sim::TreeFormula formula)
{
    sim::Scene scene = sceneOf(*tree, sim::Inertia::none);
    const sim::Resistance resistance{sim::Resistance::By::thickness, wind};
    scene.effects = {
        std::make_shared<const sim::ReturnToRest>(tree, ease),
        std::make_shared<const sim::Joints>(tree, sim::degreesOf(formula)),
        std::make_shared<const sim::TreeWind>(tree, formula, resistance, sim::Turbulence{turbulence, seed})};
    return scene;
}

sim::Scene thatSwings(const sim::TreePtr &tree)
{
    sim::Scene scene = sceneOf(*tree, sim::Inertia::some);
    scene.start.spin = Eigen::ArrayXd::Zero(tree->branches());
    const sim::Limbs limbs = sim::limbsOf(*tree, 0.05);
    scene.effects = {std::make_shared<const sim::GustFront>(12.0),
                     std::make_shared<const sim::Torsion>(tree, limbs),
                     std::make_shared<const sim::WindTorque>(tree, limbs.inertia, 5.0, 0.6),
                     std::make_shared<const sim::SpinDamping>(0.96),
                     std::make_shared<const sim::Joints>(tree, sim::degreesPerRadian)};
    return scene;
}

}
