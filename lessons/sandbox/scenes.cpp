#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/all_effects.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/rules/rule_force.h"

#include <algorithm>
#include <numbers>
#include <utility>

using namespace sim;
using namespace lessons;

namespace sandbox {

namespace {

constexpr double rad(double degrees)
{
    return degrees / 180.0 * std::numbers::pi;
}

}

std::shared_ptr<const Blueprint> defaultBlueprint()
{
    Blueprint plan;
    plan.points = {{.name = "p0", .x = {270, 80}, .v = {}, .size = 10.0, .fixed = true},
                   {.name = "p1", .x = {340, 160}, .v = {}, .size = 24.0}};
    plan.springs = {{.a = 0, .b = 1, .k = 0.1, .length = 90.0}};
    plan.effects = {"gravity", "damping", "walls"};
    return std::make_shared<const Blueprint>(std::move(plan));
}

const Blueprint &planOf(const Values &values)
{
    static const std::shared_ptr<const Blueprint> fallback = defaultBlueprint();
    return values.blueprint ? *values.blueprint : *fallback;
}

Scene pointsOf(const Blueprint &plan)
{
    const int count = static_cast<int>(plan.points.size());
    Scene scene;
    scene.start = State::ofPoints(count);
    scene.groups = {{SIM_TEXT("points"), {0, count}}};
    for (int i = 0; i < count; ++i) {
        const BlueprintPoint &point = plan.points[static_cast<std::size_t>(i)];
        scene.names.push_back(point.name);
        scene.start.place(i, point.x);
        if (!point.fixed)
            scene.start.setVelocity(i, point.v);
        scene.start.inverseMass[i] = point.fixed ? 0.0 : 1.0 / point.mass;
    }
    return scene;
}

std::vector<Spring> springsOf(const Blueprint &plan)
{
    std::vector<Spring> all;
    for (const BlueprintSpring &spring : plan.springs)
        all.push_back({spring.a, spring.b, spring.k, spring.length});
    return all;
}

std::vector<Stick> sticksOf(const Blueprint &plan)
{
    std::vector<Stick> all;
    for (const BlueprintStick &stick : plan.sticks)
        all.push_back({stick.a, stick.b, stick.length, stick.share});
    return all;
}

std::vector<Leg> legsOf(const Blueprint &plan, int gait)
{
    std::vector<Leg> legs;
    for (const BlueprintFoot &foot : plan.feet) {
        if (foot.gait == gait)
            legs.push_back({foot.foot, foot.body, rad(foot.angle), gait});
    }
    return legs;
}

LegRule ruleOf(const BlueprintGait &gait)
{
    // A clock that stays at 0 turns no leg.
    const bool swings = gait.speed != 0.0 || gait.start != 0.0;
    return {
        .k = gait.k,
        .leg = gait.leg,
        .drop = gait.drop,
        .aim = swings ? Aim::swing : Aim::below,
        .reaction = gait.pullsBody ? Reaction::equal : Reaction::none,
    };
}

void setClocks(Scene &scene, const Blueprint &plan)
{
    scene.start.gait.setZero(clockCount(plan));
    scene.start.gaitSpeed.setZero(clockCount(plan));
    Eigen::Index clock = 0;
    for (const BlueprintGait &gait : plan.gaits) {
        scene.start.gait[clock] = gait.start;
        scene.start.gaitSpeed[clock++] = gait.speed;
    }
    if (hasEffect(plan, "breeze"))
        scene.start.gaitSpeed[windClockOf(plan)] = windClock;
    if (hasRuleClock(plan))
        scene.start.gaitSpeed[ruleClockOf(plan)] = 1.0;
}

bool hasClocks(const Blueprint &plan, const Values &values)
{
    return hasRuleClock(plan) || (hasEffect(plan, "breeze") && values["gusts"] > 0.0) ||
           std::any_of(plan.feet.begin(), plan.feet.end(), [&](const BlueprintFoot &foot) {
               return plan.gaits[static_cast<std::size_t>(foot.gait)].speed != 0.0;
           });
}

// Learners read the function below in a narrow panel.
// clang-format off

namespace build {

//! [build]
Scene setUp(const Values &values)
{
    const Blueprint &plan = planOf(values);
    Scene scene = pointsOf(plan);
    const int count = scene.start.pointCount();
    setClocks(scene, plan);

    if (!plan.springs.empty())
        add<Springs>(scene,
            springsOf(plan), count);
    int group = 0;
    for (const BlueprintGait &gait : plan.gaits) {
        auto legs = legsOf(plan, group++);
        if (!legs.empty())
            add<LegSpring>(scene,
                legs, ruleOf(gait));
    }
    if (plan.rule)
        scene.effects.push_back(
            ruleForceOf(plan, values));
    // the effects that are switched on
    auto chosen = chosenEffects(
        allEffects(), plan, values);
    for (EffectPtr &one : chosen.beforeMove)
        scene.effects.push_back(one);
    if (!plan.sticks.empty())
        add<Sticks>(scene,
            sticksOf(plan), count,
            values.integer("iterations"));
    for (EffectPtr &one : chosen.afterMove)
        scene.effects.push_back(one);
    if (hasClocks(plan, values))
        add<GaitClock>(scene, clockOf(plan));
    return scene;
}
//! [build]

}

}
