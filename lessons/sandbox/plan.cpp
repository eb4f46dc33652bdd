#include "plan.h"

#include <algorithm>
#include <numbers>

namespace sandbox {

namespace {

constexpr double rad(double degrees)
{
    return degrees / 180.0 * std::numbers::pi;
}

}

std::shared_ptr<const sim::Blueprint> firstPlan()
{
    sim::Blueprint plan;
    plan.points = {{.name = "p0", .x = {270, 80}, .v = {}, .size = 10.0, .fixed = true},
                   {.name = "p1", .x = {340, 160}, .v = {}, .size = 24.0}};
    plan.springs = {{.a = 0, .b = 1, .k = 0.1, .length = 90.0}};
    plan.effects = {"gravity", "damping", "walls"};
    return std::make_shared<const sim::Blueprint>(std::move(plan));
}

const sim::Blueprint &planOf(const sim::Values &values)
{
    static const std::shared_ptr<const sim::Blueprint> first = firstPlan();
    return values.blueprint ? *values.blueprint : *first;
}

sim::Scene pointsOf(const sim::Blueprint &plan)
{
    const int count = static_cast<int>(plan.points.size());
    sim::Scene scene;
    scene.start = sim::State::ofPoints(count);
    scene.groups = {{SIM_TEXT("points"), {0, count}}};
    for (int i = 0; i < count; ++i) {
        const sim::BuiltPoint &one = plan.points[static_cast<std::size_t>(i)];
        scene.names.push_back(one.name);
        scene.start.place(i, one.x);
        if (!one.fixed)
            scene.start.push(i, one.v);
        scene.start.inverseMass[i] = one.fixed ? 0.0 : 1.0 / one.mass;
    }
    return scene;
}

std::vector<sim::Spring> springsOf(const sim::Blueprint &plan)
{
    std::vector<sim::Spring> all;
    for (const sim::BuiltSpring &one : plan.springs)
        all.push_back({one.a, one.b, one.k, one.length});
    return all;
}

std::vector<sim::Stick> sticksOf(const sim::Blueprint &plan)
{
    std::vector<sim::Stick> all;
    for (const sim::BuiltStick &one : plan.sticks)
        all.push_back({one.a, one.b, one.length, one.share});
    return all;
}

std::vector<sim::Leg> legsOf(const sim::Blueprint &plan, int gait)
{
    std::vector<sim::Leg> legs;
    for (const sim::BuiltFoot &one : plan.feet) {
        if (one.gait == gait)
            legs.push_back({one.foot, one.body, rad(one.angle), gait});
    }
    return legs;
}

sim::LegRule ruleOf(const sim::BuiltGait &gait)
{
    // A clock that stands where it began turns no leg.
    const bool swings = gait.speed != 0.0 || gait.start != 0.0;
    return {
        .k = gait.k,
        .leg = gait.leg,
        .drop = gait.drop,
        .aim = swings ? sim::Aim::swing : sim::Aim::below,
        .reaction = gait.pullsBody ? sim::Reaction::equal : sim::Reaction::none,
    };
}

void setClocks(sim::Scene &scene, const sim::Blueprint &plan)
{
    scene.start.gait.setZero(sim::clocksOf(plan));
    scene.start.gaitSpeed.setZero(sim::clocksOf(plan));
    Eigen::Index clock = 0;
    for (const sim::BuiltGait &gait : plan.gaits) {
        scene.start.gait[clock] = gait.start;
        scene.start.gaitSpeed[clock++] = gait.speed;
    }
    if (sim::has(plan, "breeze"))
        scene.start.gaitSpeed[sim::windClockOf(plan)] = windClock;
}

bool hasClocks(const sim::Blueprint &plan, const sim::Values &values)
{
    return (sim::has(plan, "breeze") && values["gusts"] > 0.0) ||
           std::any_of(plan.feet.begin(), plan.feet.end(), [&](const sim::BuiltFoot &one) {
               return plan.gaits[static_cast<std::size_t>(one.gait)].speed != 0.0;
           });
}

}
