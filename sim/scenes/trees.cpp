#include "sim/scenes/trees.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gust.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/wind_torque.h"
#include "sim/scenes/points.h"

namespace scenes {

sim::Tree forkedTree(int levels, double slope, double baseLength)
{
    constexpr double spread = 30.0; // degrees
    sim::Tree tree = sim::Tree::ofTrunk(baseLength);
    for (int level = 0, first = 0; level < levels; ++level) {
        const int end = tree.branchCount();
        for (int i = first; i < end; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const double angle = tree.rest[index], scale = slope * tree.scale[index];
            tree.addBranch(i, angle - spread, scale);
            tree.addBranch(i, angle + spread, scale);
        }
        first = end;
    }
    return tree;
}

sim::Tree bush()
{
    sim::Tree tree = sim::Tree::ofTrunk(100.0);
    tree.addBranch(0, -30.0, 0.8);
    tree.addBranch(0, 30.0, 0.7);
    return tree;
}

sim::Scene branchesOf(const sim::Tree &tree)
{
    const int branches = tree.branchCount();
    sim::Scene scene;
    scene.start = sim::State::ofPoints(branches);
    scene.start.angle = Eigen::Map<const Eigen::ArrayXd>(tree.rest.data(), branches);
    scene.names.reserve(tree.rest.size());
    for (int i = 0; i < branches; ++i)
        scene.names.push_back(SIM_TEXT("branch") + std::to_string(i));
    scene.groups = {{SIM_TEXT("branches"), {0, branches}, sim::Motion::prescribed}};
    return scene;
}

sim::Scene standingTree(const sim::Tree &tree, sim::Vec2 root, sim::TreeFormula formula)
{
    sim::Scene scene = branchesOf(tree);
    scene.start.place(0, root);
    sim::forEachFromTrunk(tree, scene.start, sim::degreesOf(formula), [](int) {});
    return scene;
}

void enableSpins(sim::Scene &scene)
{
    scene.start.spin.setZero(scene.start.pointCount());
    scene.groups.front().motion = sim::Motion::byVelocity;
}

void addSway(sim::Scene &scene, const sim::TreePtr &tree, const Sway &sway)
{
    const sim::BranchMechanics mechanics = sim::branchMechanicsOf(*tree, sway.k);
    add<sim::GustFront>(scene, sway.front);
    add<sim::Torsion>(scene, tree, mechanics);
    add<sim::WindTorque>(scene, tree, mechanics.inertia, sway.wind, sway.gusts);
    add<sim::SpinDamping>(scene, sway.damp);
    add<sim::Joints>(scene, tree, sim::degreesPerRadian);
}

}
