#include "sim/catalogue/scenes.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"

namespace sim::hard {

using std::make_shared;

namespace {

/// Points p0, p1... in one group, at rest at `places`.
Scene pointsAt(const std::vector<Vec2> &places)
{
    Scene scene;
    const int count = static_cast<int>(places.size());
    scene.start = State::ofPoints(count);
    for (int i = 0; i < count; ++i) {
        scene.start.place(i, places[static_cast<std::size_t>(i)]);
        scene.names.push_back(std::string("p").append(std::to_string(i)));
    }
    scene.groups = {{SIM_TEXT("points"), {0, count}}};
    return scene;
}

void holdFast(Scene &scene, int point)
{
    scene.start.inverseMass[point] = 0.0;
}

}

Scene contradiction(const Values &values)
{
    Scene scene = pointsAt({middle, middle + Vec2{1.0, 0.0}, middle + Vec2{0.5, 1.0}});
    const std::vector<Stick> sticks = {{0, 1, 1.0}, {1, 2, 1.0}, {0, 2, 10.0}};
    scene.effects = {make_shared<Damping>(values["damp"]), make_shared<Sticks>(sticks, 3, 10)};
    return scene;
}

Scene stretchedChain(const Values &values)
{
    constexpr double apart = 440.0;
    const int links = values.whole("links");
    const double each = apart / links;
    std::vector<Vec2> places;
    std::vector<Stick> sticks;
    for (int i = 0; i <= links; ++i) {
        places.push_back({middle.x - apart / 2.0 + i * each, middle.y});
        if (i > 0)
            sticks.push_back({i - 1, i, each / values["stretched"]});
    }
    Scene scene = pointsAt(places);
    holdFast(scene, 0);
    holdFast(scene, links);
    scene.effects = {make_shared<Gravity>(values["gravity"]), make_shared<Damping>(values["damp"]),
                     make_shared<Sticks>(sticks, links + 1, values.whole("passes"))};
    return scene;
}

Scene noLengthStick(const Values &values)
{
    Scene scene = pointsAt({middle, middle, middle + Vec2{60.0, 0.0}});
    holdFast(scene, 0);
    const std::vector<Stick> sticks = {{0, 1, 0.0}, {1, 2, 60.0}};
    scene.effects = {make_shared<Gravity>(values["gravity"]), make_shared<Damping>(values["damp"]),
                     make_shared<Sticks>(sticks, 3, 20)};
    return scene;
}

Scene fixedStick(const Values &values)
{
    Scene scene = pointsAt({middle - Vec2{50.0, 0.0}, middle + Vec2{50.0, 0.0}, middle + Vec2{90.0, 0.0}});
    holdFast(scene, 0);
    holdFast(scene, 1);
    const std::vector<Stick> sticks = {{0, 1, 50.0}, {1, 2, 40.0}};
    scene.effects = {make_shared<Gravity>(values["gravity"]), make_shared<Damping>(values["damp"]),
                     make_shared<Sticks>(sticks, 3, 4)};
    return scene;
}

}
