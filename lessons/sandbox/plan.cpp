#include "plan.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

namespace sandbox {

namespace {

constexpr double rad(double degrees)
{
    return degrees / 180.0 * std::numbers::pi;
}

int gaitsOf(const sim::Blueprint &plan)
{
    return static_cast<int>(plan.gaits.size());
}

}

std::shared_ptr<const sim::Blueprint> firstPlan()
{
    sim::Blueprint plan;
    plan.points = {{"p0", {270, 80}, {}, 1.0, 10.0, true}, {"p1", {340, 160}, {}, 1.0, 24.0, false}};
    plan.springs = {{0, 1, 0.1, 90.0}};
    plan.effects = {"gravity", "damping", "walls"};
    return std::make_shared<const sim::Blueprint>(std::move(plan));
}

const sim::Blueprint &planOf(const sim::Values &values)
{
    static const std::shared_ptr<const sim::Blueprint> first = firstPlan();
    return values.blueprint ? *values.blueprint : *first;
}

bool has(const sim::Blueprint &plan, const std::string &id)
{
    return std::find(plan.effects.begin(), plan.effects.end(), id) != plan.effects.end();
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

Eigen::ArrayXd widths(const sim::Blueprint &plan)
{
    Eigen::ArrayXd all(static_cast<Eigen::Index>(plan.points.size()));
    for (Eigen::Index i = 0; i < all.size(); ++i)
        all[i] = plan.points[static_cast<std::size_t>(i)].size;
    return all;
}

Eigen::ArrayXd halfWidths(const sim::Blueprint &plan)
{
    return 0.5 * widths(plan);
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
    return {gait.k, gait.leg, gait.drop, swings ? sim::Aim::swing : sim::Aim::below,
            gait.pullsBody ? sim::Reaction::equal : sim::Reaction::none};
}

std::vector<int> feetOf(const sim::Blueprint &plan)
{
    std::vector<int> feet;
    for (const sim::BuiltFoot &one : plan.feet)
        feet.push_back(one.foot);
    std::sort(feet.begin(), feet.end());
    return feet;
}

int windClockOf(const sim::Blueprint &plan)
{
    return gaitsOf(plan);
}

void setClocks(sim::Scene &scene, const sim::Blueprint &plan)
{
    scene.start.gait.setZero(gaitsOf(plan) + 2);
    scene.start.gaitSpeed.setZero(gaitsOf(plan) + 2);
    for (int i = 0; i < gaitsOf(plan); ++i) {
        scene.start.gait[i] = plan.gaits[static_cast<std::size_t>(i)].start;
        scene.start.gaitSpeed[i] = plan.gaits[static_cast<std::size_t>(i)].speed;
    }
    if (has(plan, "breeze"))
        scene.start.gaitSpeed[windClockOf(plan)] = windClock;
}

std::vector<int> clockOf(const sim::Blueprint &plan)
{
    std::vector<int> clocks(plan.points.size(), gaitsOf(plan) + 1);
    for (const sim::BuiltFoot &one : plan.feet) {
        clocks[static_cast<std::size_t>(one.foot)] = one.gait;
        clocks[static_cast<std::size_t>(one.body)] = one.gait;
    }
    return clocks;
}

std::vector<std::vector<int>> matesOf(const sim::Blueprint &plan)
{
    std::map<int, std::set<int>> ofBody;
    for (const sim::BuiltFoot &one : plan.feet)
        ofBody[one.body].insert(one.gait);
    std::vector<std::set<int>> mates(static_cast<std::size_t>(gaitsOf(plan) + 2));
    for (const auto &[body, clocks] : ofBody) {
        for (const int clock : clocks)
            mates[static_cast<std::size_t>(clock)].insert(clocks.begin(), clocks.end());
    }
    std::vector<std::vector<int>> all;
    for (std::size_t i = 0; i < mates.size(); ++i) {
        mates[i].erase(static_cast<int>(i));
        all.emplace_back(mates[i].begin(), mates[i].end());
    }
    return all;
}

bool hasClocks(const sim::Blueprint &plan, const sim::Values &values)
{
    return (has(plan, "breeze") && values["gusts"] > 0.0) ||
           std::any_of(plan.feet.begin(), plan.feet.end(), [&](const sim::BuiltFoot &one) {
               return plan.gaits[static_cast<std::size_t>(one.gait)].speed != 0.0;
           });
}

sim::Room roomOf(const sim::Values &values)
{
    const double bounce = values["bounce"];
    return {values["left"], values["right"], values["floor"], bounce};
}

sim::Incline rampOf(const sim::Values &values)
{
    return sim::inclineOf({values["ramp_x"], values["ramp_y"]}, values["ramp"], values["bounce"]);
}

}
