#include "tests/bench/scenes/crowd.h"

#include "sim/base/random.h"
#include "sim/effects/all_effects.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/springs/springs.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "sim/scenes/creatures.h"

namespace bench::crowd {

namespace {

/// Returns creatures with springs and no other effect, at random positions in the room. Feet are within 50 px
/// of their body.
sim::Scene sprung(int creatures)
{
    sim::Scene scene = scenes::crowdByParts(creatures, feet);
    for (int creature = 0; creature < creatures; ++creature) {
        auto between = [&, drawn = 0](double low, double high) mutable {
            return low + (high - low) * sim::uniform(1, drawn++, creature);
        };
        const sim::Vec2 body = {between(left + 65.0, right - 65.0), between(50.0, floor - 65.0)};
        scene.start.place(pointOf(creatures, creature, -1), body);
        for (int foot = 0; foot < feet; ++foot) {
            const sim::Vec2 off = {between(-50.0, 50.0), between(-50.0, 50.0)};
            scene.start.place(pointOf(creatures, creature, foot), body + off);
        }
    }
    scenes::add<sim::RadialSpring>(scene, scenes::legsByParts(creatures, feet), k, radius);
    return scene;
}

}

sim::Scene inTheRoom(int creatures)
{
    sim::Scene scene = sprung(creatures);
    Eigen::ArrayXd half = Eigen::ArrayXd::Constant(points * creatures, halfFoot);
    half.head(creatures).setConstant(halfBody);
    scenes::add<sim::Gravity>(scene, gravity);
    scenes::add<sim::Damping>(scene, damp);
    scenes::add<sim::Walls>(scene, sim::Room{left, right, floor, bounce}, half);
    return scene;
}

sim::Scene builtInTheRoom(int creatures)
{
    sim::Scene scene = inTheRoom(creatures);
    sim::Blueprint plan;
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        sim::BlueprintPoint point{scene.names[static_cast<std::size_t>(i)], scene.start.positionOf(i), {}};
        point.size = 2.0 * (i < creatures ? halfBody : halfFoot);
        plan.points.push_back(std::move(point));
    }
    plan.effects = {"gravity", "damping", "walls"};
    sim::Values values;
    for (const auto &[id, value] :
         std::initializer_list<std::pair<const char *, double>>{{"gravity", gravity},
                                                                {"damp", damp},
                                                                {"left", left},
                                                                {"right", right},
                                                                {"floor", floor},
                                                                {"bounce", bounce}})
        values.set(id, value);
    std::vector<sim::Spring> own;
    for (int foot = 0; foot < feet; ++foot) {
        for (int creature = 0; creature < creatures; ++creature)
            own.push_back({pointOf(creatures, creature, foot), creature, k, radius});
    }
    sim::ChosenEffects chosen = sim::chosenEffects(sim::allEffects(), plan, values);
    scene.effects = std::move(chosen.beforeMove);
    scene.effects.insert(scene.effects.begin(),
                         std::make_shared<sim::Springs>(own, scene.start.pointCount()));
    scene.effects.insert(scene.effects.end(), chosen.afterMove.begin(), chosen.afterMove.end());
    return scene;
}

sim::Scene inTheAir(int creatures)
{
    sim::Scene scene = sprung(creatures);
    scenes::add<sim::Damping>(scene, damp);
    return scene;
}

}
