#include "sim/scenes/creatures.h"

#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/radial_spring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenes {

namespace {

sim::Scene pointsAtCentre(int points)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(points);
    scene.start.position.col(0) = centre.x;
    scene.start.position.col(1) = centre.y;
    scene.names.reserve(static_cast<std::size_t>(points));
    return scene;
}

/// Returns `scene` with the body of its creature, the last point, as a handle.
sim::Scene withBodyAsHandle(sim::Scene scene)
{
    scene.start.inverseMass[scene.start.pointCount() - 1] = 0.0;
    scene.groups.pop_back();
    return scene;
}

}

sim::Scene creature(int feet)
{
    sim::Scene scene = pointsAtCentre(feet + 1);
    for (int i = 0; i < feet; ++i)
        scene.names.push_back("foot" + std::to_string(i));
    scene.names.push_back("body");
    scene.groups = {{SIM_TEXT("feet"), {0, feet}}, {SIM_TEXT("body"), {feet, 1}}};
    return scene;
}

sim::Scene creatureOnHandle(int feet)
{
    return withBodyAsHandle(creature(feet));
}

sim::Scene pair()
{
    sim::Scene scene = creature(1);
    scene.names.front() = "foot";
    scene.groups.front().title = SIM_TEXT("foot");
    return scene;
}

sim::Scene pairOnHandle()
{
    return withBodyAsHandle(pair());
}

sim::Scene singleFoot()
{
    return onePoint(SIM_TEXT("foot"), centre);
}

sim::Scene springCreature(int feet, double k, double length)
{
    sim::Scene scene = creature(feet);
    add<sim::RadialSpring>(scene, legs(feet), k, length);
    return scene;
}

sim::Scene linearCreature(int feet, double k)
{
    sim::Scene scene = creature(feet);
    add<sim::BodySpring>(scene, legs(feet), k);
    return scene;
}

sim::Scene crowd(int creatures, int feet)
{
    sim::Scene scene = pointsAtCentre(creatures * (feet + 1));
    for (int creature = 0; creature < creatures; ++creature) {
        const std::string name = SIM_TEXT("creature") + std::to_string(creature);
        const int first = creature * (feet + 1);
        for (int i = 0; i < feet; ++i)
            scene.names.push_back(name + ".foot" + std::to_string(i));
        scene.names.push_back(name + ".body");
        scene.groups.push_back({SIM_TEXT("feet"), {first, feet}});
        scene.groups.push_back({SIM_TEXT("body"), {first + feet, 1}});
    }
    return scene;
}

sim::Scene crowdByParts(int creatures, int feet)
{
    sim::Scene scene = pointsAtCentre(creatures * (feet + 1));
    const auto namePart = [&](const std::string &part) {
        for (int creature = 0; creature < creatures; ++creature)
            scene.names.push_back(SIM_TEXT("creature") + std::to_string(creature) + part);
    };
    namePart(".body");
    for (int i = 0; i < feet; ++i)
        namePart(".foot" + std::to_string(i));
    scene.groups.push_back({SIM_TEXT("feet"), {creatures, creatures * feet}});
    scene.groups.push_back({SIM_TEXT("bodies"), {0, creatures}});
    return scene;
}

void placeFeet(sim::Scene &scene, const std::vector<sim::Vec2> &positions)
{
    const int feet = scene.start.pointCount() - 1;
    const int placed = std::min(feet, static_cast<int>(positions.size()));
    for (int i = 0; i < placed; ++i)
        scene.start.place(i, positions[static_cast<std::size_t>(i)]);
    const sim::Vec2 body = scene.start.positionOf(feet);
    for (int i = placed; i < feet; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i - placed) / (feet - placed);
        scene.start.place(i, body + spareDistance * sim::Vec2{std::cos(angle), std::sin(angle)});
    }
}

bool isBody(const std::string &name)
{
    return name == "body" || name.ends_with(".body");
}

Eigen::ArrayXd halfWidths(const sim::Scene &scene)
{
    Eigen::ArrayXd halfWidth = Eigen::ArrayXd::Constant(scene.start.pointCount(), footWidth / 2);
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        if (isBody(scene.names[static_cast<std::size_t>(i)]))
            halfWidth[i] = bodyWidth / 2;
    }
    return halfWidth;
}

}
