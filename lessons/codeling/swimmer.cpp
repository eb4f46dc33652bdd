#include "swimmer.h"

#include <cmath>
#include <numbers>
#include <string>

namespace codeling {

namespace {

/// Adds `count` points, all at (0, 0), to the end of a state.
void grow(sim::State &state, int count)
{
    const int before = state.points();
    sim::State grown = sim::State::ofPoints(before + count);
    grown.position.topRows(before) = state.position;
    grown.outside = state.outside;
    state = std::move(grown);
}

/// The direction in which tentacle `number` of `count` starts: they fan out behind, from -60 to 60 degrees.
sim::Vec2 fan(int number, int count)
{
    const double spread = std::numbers::pi / 3;
    const double angle = std::numbers::pi + spread - 2.0 * spread * (number + 0.5) / count;
    return {std::cos(angle), -std::sin(angle)};
}

}

sim::Scene swimmer(const sim::Values &values)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(1);
    scene.start.place(lead, {200, 200});
    scene.start.outside.target = {values["target_x"], values["target_y"]};
    scene.names = {"lead"};
    scene.groups = {{SIM_TEXT("lead"), {lead, 1}}};
    return scene;
}

void addPoint(sim::Scene &scene, const char *name, sim::Vec2 place, sim::Inertia inertia)
{
    const int point = scene.start.points();
    grow(scene.start, 1);
    scene.start.place(point, place);
    scene.names.push_back(name);
    scene.groups.push_back({name, {point, 1}, inertia});
}

void addTail(sim::Scene &scene, const sim::Values &values, sim::Inertia inertia)
{
    addPoint(scene, SIM_TEXT("tail"), {200 - values["rest_length"], 200}, inertia);
}

void addSides(sim::Scene &scene)
{
    const sim::Vec2 middle = 0.5 * (scene.start.at(lead) + scene.start.at(tail));
    grow(scene.start, 2);
    scene.start.place(side0, middle - sim::Vec2{0, restWidth / 2});
    scene.start.place(side1, middle + sim::Vec2{0, restWidth / 2});
    scene.names.insert(scene.names.end(), {SIM_TEXT("side") "0", SIM_TEXT("side") "1"});
    scene.groups.push_back({SIM_TEXT("sides"), {side0, 2}, sim::Inertia::none});
}

std::vector<sim::Stick> addTentacles(sim::Scene &scene, int tentacles, int links)
{
    const int count = tentacles * links;
    grow(scene.start, count);
    std::vector<sim::Stick> sticks;
    for (int i = 0; i < count; ++i) {
        const int number = i / links, link = i % links;
        // The upper half of the fan starts at the upper side.
        const int root = number < (tentacles + 1) / 2 ? side0 : side1;
        const int point = firstOfTentacles + i;
        const int inner = link == 0 ? root : point - 1;
        scene.start.place(point, scene.start.at(inner) + linkLength * fan(number, tentacles));
        scene.names.push_back(SIM_TEXT("tentacle") + std::to_string(number) + "_" + std::to_string(link));
        sticks.push_back({inner, point, linkLength, 0.0});
    }
    scene.groups.push_back({SIM_TEXT("tentacles"), {firstOfTentacles, count}});
    return sticks;
}

std::vector<sim::SoftStick> sideSticks(const sim::Values &values)
{
    const double rest = std::hypot(values["rest_length"] / 2, restWidth / 2);
    std::vector<sim::SoftStick> sticks;
    for (const int side : {side0, side1}) {
        for (const int end : {lead, tail})
            sticks.push_back(
                {.anchor = end, .mover = side, .min = 0.8 * rest, .rest = rest, .max = 1.2 * rest});
    }
    return sticks;
}

double restArea(const sim::Values &values)
{
    return 0.5 * values["rest_length"] * restWidth;
}

}
