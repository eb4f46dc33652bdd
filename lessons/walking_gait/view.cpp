#include "view.h"

#include "lessons/api/creature.h"
#include "lessons/api/view/acting.h"
#include "lessons/api/view/creature_look.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/scene/values.h"

#include <QCoreApplication>

using namespace lessons;
using sim::Scene;
using sim::State;
using sim::Values;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

constexpr double noFloor = 1e4; ///< px: far below the picture

/// A foot's place is its lowest point; the disc that is drawn has its middle there. So the ground is drawn where
/// the disc ends.
double groundLine(const Values &values)
{
    return values["ground"] + footWidth / 2;
}

Guide cross(sim::Vec2 at, const QString &label = {})
{
    return {.shape = Guide::Shape::cross, .a = at, .label = label};
}

Guide line(sim::Vec2 from, sim::Vec2 to)
{
    return {.shape = Guide::Shape::line, .a = from, .b = to};
}

/// Calls `visit(leg, target)` for each leg that pulls; for none while the springs are switched off.
template <class Visit>
void forEachLeg(const Scene &scene, const State &state, Visit &&visit)
{
    for (const sim::EffectPtr &effect : scene.effects) {
        const auto *springs = dynamic_cast<const sim::LegSpring *>(effect.get());
        if (!springs)
            continue;
        const std::vector<sim::Leg> legs = springs->legs();
        for (std::size_t i = 0; i < legs.size(); ++i)
            visit(legs[i], springs->target(state, static_cast<int>(i)));
    }
}

Look withFeet(Look look)
{
    for (std::size_t i = 0; i < look.bodies.size(); ++i) {
        if (look.bodies[i].shape == BodyLook::Shape::foot)
            look.feet.push_back(static_cast<int>(i));
    }
    look.stage = {0, 40, 540, 400};
    return look;
}

}

Look plainLook(const Scene &scene, const Values &)
{
    Look look = creatureLook(scene);
    look.springs = actingSprings(scene);
    return look;
}

Look straightLegs(const Scene &scene, const Values &)
{
    return creatureLookWithLegs(scene);
}

Look curvedLegs(const Scene &scene, const Values &values)
{
    Look look = creatureLookWithLegs(scene);
    for (LegLook &leg : look.legs)
        leg.curve = values["curve"];
    return look;
}

Look onGround(const Scene &scene, const Values &values)
{
    Look look = withFeet(curvedLegs(scene, values));
    if (effectOf<sim::Ground>(scene))
        look.ground = groundLine(values);
    look.follow = scene.start.points() - 1;
    return look;
}

Look inRoom(const Scene &scene, const Values &values)
{
    Look look = withFeet(curvedLegs(scene, values));
    const bool hasGround = effectOf<sim::Ground>(scene);
    if (effectOf<sim::Walls>(scene))
        look.room = sim::Room{values["left"], values["right"], hasGround ? groundLine(values) : noFloor, 0.0};
    else if (hasGround)
        look.ground = groundLine(values);
    return look;
}

bool stands(const Scene &scene, const State &state, const Values &values, int point)
{
    return effectOf<sim::Ground>(scene) && state.feels(point) && state.at(point).y >= values["ground"];
}

Guides boneLines(const Scene &scene, const State &state, const Values &)
{
    Guides all;
    forEachLeg(scene, state, [&](const sim::Leg &leg, sim::Vec2 target) {
        all.push_back(line(state.at(leg.body), target));
        all.push_back(cross(target, Text::tr("foot %1").arg(leg.foot)));
    });
    return all;
}

Guides places(const Scene &scene, const State &state, const Values &)
{
    Guides all;
    forEachLeg(scene, state, [&](const sim::Leg &, sim::Vec2 target) { all.push_back(cross(target)); });
    return all;
}

Guides bends(const Scene &scene, const State &state, const Values &values)
{
    Guides all;
    forEachLeg(scene, state, [&](const sim::Leg &leg, sim::Vec2) {
        const sim::Vec2 foot = state.at(leg.foot);
        const sim::Vec2 bend = {foot.x, foot.y - values["curve"]};
        all.insert(all.end(), {line(foot, bend), line(bend, state.at(leg.body)), cross(bend)});
    });
    return all;
}

Guides ring(const Scene &scene, const State &state, const Values &values)
{
    Guides all = places(scene, state, values);
    const sim::Vec2 body = state.at(state.points() - 1);
    all.push_back(
        {.shape = Guide::Shape::ring, .a = {body.x, body.y + values["drop"]}, .size = values["leg"]});
    return all;
}

Guides middleAndPlaces(const Scene &scene, const State &state, const Values &values)
{
    Guides all = places(scene, state, values);
    const auto mean = state.position.colwise().mean().eval();
    all.push_back(cross({mean[0], mean[1]}, Text::tr("middle")));
    return all;
}

}
