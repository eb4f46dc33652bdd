#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drags/split_damping.h"
#include "sim/effects/drivers/motor.h"

#include <cmath>
#include <numbers>
#include <string>

using namespace sim;
using namespace lessons;

namespace codeling {

using sim::PointRange; // not lessons::PointRange

namespace {

/// Appends `count` points at (0, 0) to a state. Velocities and masses become those of a new state.
void grow(State &state, int count)
{
    const int before = state.pointCount();
    State grown = State::ofPoints(before + count);
    grown.position.topRows(before) = state.position;
    grown.input = state.input;
    state = std::move(grown);
}

/// Returns the start direction of tentacle `index` of `count`. The tentacles fan out over 120 degrees behind
/// the body.
Vec2 fanDirection(int index, int count)
{
    const double spread = std::numbers::pi / 3;
    const double angle = std::numbers::pi + spread - 2.0 * spread * (index + 0.5) / count;
    return {std::cos(angle), -std::sin(angle)};
}

/// Adds a point as a new group with this motion.
void addPoint(Scene &scene, const char *name, Vec2 position, Motion motion)
{
    const int point = scene.start.pointCount();
    grow(scene.start, 1);
    scene.start.place(point, position);
    scene.names.push_back(name);
    scene.groups.push_back({name, {point, 1}, motion});
}

}

Scene swimmer(const Values &values)
{
    Scene scene;
    scene.start = State::ofPoints(1);
    scene.start.place(lead, {200, 200});
    scene.start.input.target = {values["target_x"], values["target_y"]};
    scene.names = {"lead"};
    scene.groups = {{SIM_TEXT("lead"), {lead, 1}}};
    return scene;
}

void addTail(Scene &scene, const Values &values, Motion motion)
{
    addPoint(scene, SIM_TEXT("tail"), {200 - values["rest_length"], 200}, motion);
}

void addSides(Scene &scene)
{
    const Vec2 middle = 0.5 * (scene.start.positionOf(lead) + scene.start.positionOf(tail));
    grow(scene.start, 2);
    scene.start.place(side0, middle - Vec2{0, restWidth / 2});
    scene.start.place(side1, middle + Vec2{0, restWidth / 2});
    scene.names.insert(scene.names.end(), {SIM_TEXT("side") "0", SIM_TEXT("side") "1"});
    scene.groups.push_back({SIM_TEXT("sides"), {side0, 2}, Motion::prescribed});
}

std::vector<Stick> addTentacles(Scene &scene, int tentacles, int links)
{
    const int count = tentacles * links;
    grow(scene.start, count);
    std::vector<Stick> sticks;
    for (int i = 0; i < count; ++i) {
        const int chain = i / links, link = i % links;
        // The upper half of the fan starts at the upper side, side 0.
        const int root = chain < (tentacles + 1) / 2 ? side0 : side1;
        const int point = firstOfTentacles + i;
        const int inner = link == 0 ? root : point - 1;
        scene.start.place(point, scene.start.positionOf(inner) + linkLength * fanDirection(chain, tentacles));
        scene.names.push_back(SIM_TEXT("tentacle") + std::to_string(chain) + "_" + std::to_string(link));
        sticks.push_back({inner, point, linkLength, 0.0});
    }
    scene.groups.push_back({SIM_TEXT("tentacles"), {firstOfTentacles, count}});
    return sticks;
}

std::vector<SoftStick> sideSticks(const Values &values)
{
    const double rest = std::hypot(values["rest_length"] / 2, restWidth / 2);
    std::vector<SoftStick> sticks;
    for (const int side : {side0, side1}) {
        for (const int end : {lead, tail})
            sticks.push_back(
                {.anchor = end, .mover = side, .min = 0.8 * rest, .rest = rest, .max = 1.2 * rest});
    }
    return sticks;
}

double restArea(const Values &values)
{
    return 0.5 * values["rest_length"] * restWidth;
}

// Learners read the functions below in a narrow panel.
// clang-format off

namespace motor {

//! [motor]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);

    double keep = values["keep"];
    add<Damping>(scene, keep, PointRange{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);
    return scene;
}
//! [motor]

}

namespace orientation {

//! [orientation]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Motion::prescribed);

    double keep = values["keep"];
    add<Damping>(scene, keep, PointRange{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double rest = values["rest_length"];
    const double share = 0; // none for the lead
    std::vector<Stick> spine = {
        {lead, tail, rest, share}};
    add<Sticks>(scene, spine,
                scene.start.pointCount());
    return scene;
}
//! [orientation]

}

namespace anticipation {

//! [anticipation]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Motion::prescribed);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, PointRange{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double rest = values["rest_length"];
    const double share = 0; // none for the lead
    std::vector<Stick> spine = {
        {lead, tail, rest, share}};
    add<Sticks>(scene, spine,
                scene.start.pointCount());
    return scene;
}
//! [anticipation]

}

namespace squash_stretch {

//! [squash_stretch]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Motion::byVelocity);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, PointRange{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double along = values["along"];
    double across = values["across"];
    add<SplitDamping>(scene, tail, lead,
                      along, across);

    std::vector<SoftStick> spine = {
        {lead, tail, values["min_length"],
         values["rest_length"],
         values["max_length"]}};
    Strengths strength;
    strength.soft = values["soft"];
    strength.hard = values["hard"];
    add<SoftSticks>(scene, spine, strength);
    return scene;
}
//! [squash_stretch]

}

namespace volume {

//! [volume]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Motion::byVelocity);
    addSides(scene);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, PointRange{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double along = values["along"];
    double across = values["across"];
    add<SplitDamping>(scene, tail, lead,
                      along, across);

    std::vector<SoftStick> soft = {
        {lead, tail, values["min_length"],
         values["rest_length"],
         values["max_length"]}};
    for (SoftStick one : sideSticks(values))
        soft.push_back(one); // two a side
    Strengths strength;
    strength.soft = values["soft"];
    strength.hard = values["hard"];
    add<SoftSticks>(scene, soft, strength);

    double area = restArea(values);
    add<AreaStick>(scene, corners, area,
                   shortestSpine);
    return scene;
}
//! [volume]

}

namespace tentacles {

//! [tentacles]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Motion::byVelocity);
    addSides(scene);
    int chains = values.integer("tentacles");
    int each = values.integer("links");
    std::vector<Stick> links =
        addTentacles(scene, chains, each);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, PointRange{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double along = values["along"];
    double across = values["across"];
    add<SplitDamping>(scene, tail, lead,
                      along, across);
    double water = values["water"];
    add<Damping>(scene, water,
        PointRange{firstOfTentacles, chains * each});

    std::vector<SoftStick> soft = {
        {lead, tail, values["min_length"],
         values["rest_length"],
         values["max_length"]}};
    for (SoftStick one : sideSticks(values))
        soft.push_back(one); // two a side
    Strengths strength;
    strength.soft = values["soft"];
    strength.hard = values["hard"];
    add<SoftSticks>(scene, soft, strength);

    double area = restArea(values);
    add<AreaStick>(scene, corners, area,
                   shortestSpine);
    add<Sticks>(scene, links,
                scene.start.pointCount());
    return scene;
}
//! [tentacles]

}

}
