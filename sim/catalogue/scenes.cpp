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
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"

#include <numbers>

namespace sim::hard {

using std::make_shared;
using std::numbers::pi;

namespace {

/// `feet` feet and then a body, all at rest in the middle; the feet move before the body.
Scene bodyWithFeet(int feet)
{
    Scene scene;
    scene.start = State::ofPoints(feet + 1);
    for (int i = 0; i <= feet; ++i)
        scene.start.place(i, middle);
    for (int i = 0; i < feet; ++i)
        scene.names.push_back("foot" + std::to_string(i));
    scene.names.push_back("body");
    scene.groups = {{SIM_TEXT("feet"), {0, feet}}, {SIM_TEXT("body"), {feet, 1}}};
    return scene;
}

/// From each foot to the body, and from the body to each foot.
std::vector<Link> bothWays(int feet)
{
    std::vector<Link> links;
    for (int i = 0; i < feet; ++i)
        links.push_back({i, feet});
    for (int i = 0; i < feet; ++i)
        links.push_back({feet, i});
    return links;
}

void addSpringsAndDamping(Scene &scene, const Values &values)
{
    const int feet = scene.start.points() - 1;
    scene.effects.push_back(make_shared<RadialSpring>(bothWays(feet), values["k"], values["radius"]));
    scene.effects.push_back(make_shared<Damping>(values["damp"]));
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
    Scene scene;
    scene.start = State::ofPoints(1);
    scene.start.place(0, middle + Vec2{100.0, 0.0});
    scene.names = {"foot"};
    scene.groups = {{SIM_TEXT("foot"), {0, 1}}};
    scene.effects = {make_shared<PointSpring>(0, middle, values["k"]), make_shared<Damping>(values["damp"])};
    return scene;
}

Scene runawayPair(const Values &values)
{
    Scene scene = bodyWithFeet(1);
    scene.start.place(0, {330.0, 260.0});
    addSpringsAndDamping(scene, values);
    return scene;
}

Scene creature(const Values &values)
{
    const int feet = values.whole("feet");
    Scene scene = bodyWithFeet(feet);
    for (int i = 0; i < feet; ++i) {
        // No two are opposite, and more are on the right.
        const double share = (i + 0.5) / feet;
        const double angle = 2.0 * pi * (share + 0.05 * std::sin(2.0 * pi * share));
        scene.start.place(i, middle + values["out"] * Vec2{-std::cos(angle), std::sin(angle)});
    }
    addSpringsAndDamping(scene, values);
    return scene;
}

Scene creatureOnLine(const Values &values)
{
    const int feet = values.whole("feet");
    Scene scene = bodyWithFeet(feet);
    for (int i = 0; i < feet; ++i) {
        const double side = i % 2 == 0 ? -1.0 : 1.0;
        scene.start.place(i, middle + Vec2{side * 30.0 * (i / 2 + 1), 0.0});
    }
    addSpringsAndDamping(scene, values);
    return scene;
}

Scene creatureInRoom(const Values &values)
{
    Scene scene = creature(values);
    const int body = scene.start.points() - 1;
    Eigen::ArrayXd half = Eigen::ArrayXd::Constant(body + 1, 5.0);
    half[body] = 15.0;
    scene.effects.insert(scene.effects.begin() + 1, make_shared<Gravity>(values["gravity"]));
    scene.effects.push_back(make_shared<Walls>(
        Room{values["left"], values["right"], values["floor"], values["bounce"]}, std::move(half)));
    return scene;
}

Scene unequalPair(const Values &values)
{
    Scene scene = bodyWithFeet(1);
    scene.names = {"light", "heavy"};
    scene.groups[0].title = SIM_TEXT("light");
    scene.groups[1].title = SIM_TEXT("heavy");
    scene.start.place(0, middle + Vec2{100.0, 0.0});
    scene.start.inverseMass[1] = 1.0 / values["ratio"];
    scene.effects = {make_shared<BodySpring>(bothWays(1), values["k"]), make_shared<Damping>(values["damp"])};
    return scene;
}

Scene walker(const Values &values)
{
    Scene scene = bodyWithFeet(2);
    scene.start.place(0, {220.0, 350.0});
    scene.start.place(1, {320.0, 350.0});
    scene.start.place(2, {270.0, 300.0});
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setConstant(1, values["speed"]);
    const LegRule rule{values["k"], 50.0, 50.0, Aim::swing, Reaction::equal};
    scene.effects = {make_shared<LegSpring>(std::vector<Leg>{{0, 2, 0.0}, {1, 2, pi}}, rule),
                     make_shared<Gravity>(values["gravity"]), make_shared<Damping>(values["damp"]),
                     make_shared<Ground>(std::vector<int>{0, 1}, Soil{400.0, 0.0, Traction::full}),
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
    scene.start.outside.target = {values["target_x"], values["target_y"]};
    scene.names = {"lead", "tail"};
    scene.groups = {{SIM_TEXT("lead"), {lead, 1}},
                    {SIM_TEXT("tail"), {tail, 1}, isSoft ? Inertia::some : Inertia::none}};
    scene.effects = {make_shared<Damping>(values["keep"], Points{lead, 1}),
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
