#include "sim/scenes/points.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/point_spring.h"

namespace scenes {

sim::Scene onePoint(const std::string &name, sim::Vec2 x, sim::Vec2 v)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(1);
    scene.start.place(0, x);
    scene.start.setVelocity(0, v);
    scene.names = {name};
    scene.groups = {{name, {0, 1}}};
    return scene;
}

sim::Scene pointsAt(const std::vector<sim::Vec2> &positions)
{
    const int count = static_cast<int>(positions.size());
    sim::Scene scene;
    scene.start = sim::State::ofPoints(count);
    for (int i = 0; i < count; ++i) {
        scene.start.place(i, positions[static_cast<std::size_t>(i)]);
        scene.names.push_back(std::string("p").append(std::to_string(i)));
    }
    scene.groups = {{SIM_TEXT("points"), {0, count}}};
    return scene;
}

sim::Scene oscillator(sim::Vec2 x, sim::Vec2 anchor, double k, double damp)
{
    sim::Scene scene = onePoint(SIM_TEXT("foot"), x);
    add<sim::PointSpring>(scene, 0, anchor, k);
    add<sim::Damping>(scene, damp);
    return scene;
}

}
