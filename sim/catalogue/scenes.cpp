#include "sim/catalogue/scenes.h"

#include "sim/effects/constraints/soft_sticks.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drags/split_damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/drivers/motor.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/scenes/creatures.h"

#include <numbers>

namespace sim::hard {

using std::make_shared;
using std::numbers::pi;

namespace {

/// Returns a creature with damping. Values: k, radius, damp.
Scene dampedCreature(int feet, const Values &values)
{
    Scene scene = scenes::springCreature(feet, values["k"], values["radius"]);
    scenes::add<Damping>(scene, values["damp"]);
    return scene;
}

}

Values valuesOf(std::initializer_list<std::pair<const char *, double>> numbers)
{
    Values values;
    for (const auto &[id, value] : numbers)
        values.set(id, value);
    return values;
}

Scene footOnSpring(const Values &values)
{
    return scenes::oscillator(middle + Vec2{100.0, 0.0}, middle, values["k"], values["damp"]);
}

Scene runawayPair(const Values &values)
{
    Scene scene = dampedCreature(1, values);
    scene.start.place(0, {330.0, 260.0});
    return scene;
}

Scene creature(const Values &values)
{
    const int feet = values.integer("feet");
    Scene scene = dampedCreature(feet, values);
    for (int i = 0; i < feet; ++i) {
        // No two feet are opposite each other, and more of them are on the right.
        const double share = (i + 0.5) / feet;
        const double angle = 2.0 * pi * (share + 0.05 * std::sin(2.0 * pi * share));
        scene.start.place(i, middle + values["out"] * Vec2{-std::cos(angle), std::sin(angle)});
    }
    return scene;
}

Scene creatureOnLine(const Values &values)
{
    const int feet = values.integer("feet");
    Scene scene = dampedCreature(feet, values);
    for (int i = 0; i < feet; ++i) {
        const double side = i % 2 == 0 ? -1.0 : 1.0;
        scene.start.place(i, middle + Vec2{side * 30.0 * (i / 2 + 1), 0.0});
    }
    return scene;
}

Scene creatureInRoom(const Values &values)
{
    Scene scene = creature(values);
    scene.effects.insert(scene.effects.begin() + 1, make_shared<Gravity>(values["gravity"]));
    const Room room{values["left"], values["right"], values["floor"], values["bounce"]};
    scenes::add<Walls>(scene, room, scenes::halfWidths(scene));
    return scene;
}

Scene unequalPair(const Values &values)
{
    Scene scene = scenes::linearCreature(1, values["k"]);
    scene.names = {"light", "heavy"};
    scene.groups[0].title = SIM_TEXT("light");
    scene.groups[1].title = SIM_TEXT("heavy");
    scene.start.place(0, middle + Vec2{100.0, 0.0});
    scene.start.inverseMass[1] = 1.0 / values["ratio"];
    scenes::add<Damping>(scene, values["damp"]);
    return scene;
}

Scene walker(const Values &values)
{
    Scene scene = scenes::creature(2);
    scene.start.place(0, {220.0, 350.0});
    scene.start.place(1, {320.0, 350.0});
    scene.start.place(2, {270.0, 300.0});
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setConstant(1, values["speed"]);
    const LegRule rule{values["k"], 50.0, 50.0, Aim::swing, Reaction::equal};
    scene.effects = {make_shared<LegSpring>(std::vector<Leg>{{0, 2, 0.0}, {1, 2, pi}}, rule),
                     make_shared<Gravity>(values["gravity"]), make_shared<Damping>(values["damp"]),
                     make_shared<Ground>(std::vector<int>{0, 1}, GroundPlane{400.0, 0.0, Traction::full}),
                     make_shared<GaitClock>()};
    return scene;
}

Scene swimmer(const Values &values)
{
    const bool isSoft = values["soft"] == 1.0;
    const int lead = 0, tail = 1;
    Scene scene;
    scene.start = State::ofPoints(2);
    scene.start.place(lead, middle);
    scene.start.place(tail, middle - Vec2{values["behind"], 0.0});
    scene.start.input.target = {values["target_x"], values["target_y"]};
    scene.names = {"lead", "tail"};
    scene.groups = {{SIM_TEXT("lead"), {lead, 1}},
                    {SIM_TEXT("tail"), {tail, 1}, isSoft ? Motion::byVelocity : Motion::prescribed}};
    scene.effects = {make_shared<Damping>(values["keep"], PointRange{lead, 1}),
                     make_shared<Motor>(lead, 0.9, 0.25)};
    if (isSoft) {
        const std::vector<SoftStick> spine = {{lead, tail, 20.0, 40.0, 60.0}};
        scene.effects.push_back(make_shared<SplitDamping>(tail, lead, 0.7, 0.5));
        scene.effects.push_back(make_shared<SoftSticks>(spine, Strengths{0.1, 0.8}));
    } else {
        const std::vector<Stick> spine = {{lead, tail, 40.0, 0.0}};
        scene.effects.push_back(make_shared<Sticks>(spine, 2));
    }
    return scene;
}

}
