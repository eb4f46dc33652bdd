#include "crowd.h"

#include "sim/base/random.h"
#include "sim/effects/all_effects.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/springs/springs.h"
#include "sim/scene/built.h"
#include "sim/scene/values.h"

namespace bench::crowd {

namespace {

/// Each somewhere in the room, its feet within 50 px around its body.
sim::State start(int creatures)
{
    sim::State state = sim::State::ofPoints(points * creatures);
    for (int creature = 0; creature < creatures; ++creature) {
        auto between = [&, drawn = 0u](double low, double high) mutable {
            return low + (high - low) * sim::uniform(1, drawn++, static_cast<std::uint64_t>(creature));
        };
        const sim::Vec2 body = {between(left + 65.0, right - 65.0), between(50.0, floor - 65.0)};
        state.place(pointOf(creatures, creature, -1), body);
        for (int foot = 0; foot < feet; ++foot) {
            const sim::Vec2 off = {between(-50.0, 50.0), between(-50.0, 50.0)};
            state.place(pointOf(creatures, creature, foot), body + off);
        }
    }
    return state;
}

/// With springs, and no other effect.
sim::Scene sprung(int creatures)
{
    sim::Scene scene;
    scene.start = start(creatures);
    scene.names.reserve(static_cast<std::size_t>(points * creatures));
    for (int foot = -1; foot < feet; ++foot) {
        for (int creature = 0; creature < creatures; ++creature) {
            const std::string own = "creature" + std::to_string(creature);
            scene.names.push_back(own + (foot < 0 ? ".body" : ".foot" + std::to_string(foot)));
        }
    }
    scene.groups = {{"feet", {creatures, feet * creatures}}, {"bodies", {0, creatures}}};
    scene.effects = {std::make_shared<sim::RadialSpring>(springs(creatures), k, radius)};
    return scene;
}

}

std::vector<sim::Link> springs(int creatures)
{
    std::vector<sim::Link> links;
    links.reserve(static_cast<std::size_t>(2 * feet * creatures));
    for (int foot = 0; foot < feet; ++foot) {
        for (int creature = 0; creature < creatures; ++creature)
            links.push_back({pointOf(creatures, creature, foot), creature});
        for (int creature = 0; creature < creatures; ++creature)
            links.push_back({creature, pointOf(creatures, creature, foot)});
    }
    return links;
}

sim::Scene inTheRoom(int creatures)
{
    sim::Scene scene = sprung(creatures);
    Eigen::ArrayXd half = Eigen::ArrayXd::Constant(points * creatures, halfFoot);
    half.head(creatures).setConstant(halfBody);
    scene.effects.push_back(std::make_shared<sim::Gravity>(gravity));
    scene.effects.push_back(std::make_shared<sim::Damping>(damp));
    scene.effects.push_back(std::make_shared<sim::Walls>(sim::Room{left, right, floor, bounce}, half));
    return scene;
}

sim::Scene builtInTheRoom(int creatures)
{
    sim::Scene scene = inTheRoom(creatures);
    sim::Blueprint plan;
    for (int i = 0; i < scene.start.points(); ++i) {
        sim::BuiltPoint point{scene.names[static_cast<std::size_t>(i)], scene.start.at(i), {}};
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
    scene.effects = std::move(chosen.pulls);
    scene.effects.insert(scene.effects.begin(), std::make_shared<sim::Springs>(own, scene.start.points()));
    scene.effects.insert(scene.effects.end(), chosen.rest.begin(), chosen.rest.end());
    return scene;
}

sim::Scene inTheAir(int creatures)
{
    sim::Scene scene = sprung(creatures);
    scene.effects.push_back(std::make_shared<sim::Damping>(damp));
    return scene;
}

}
