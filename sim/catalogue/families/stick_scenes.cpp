#include "sim/catalogue/scenes.h"
#include "sim/effects/drags/damping.h"
#include "sim/scenes/points.h"
#include "sim/scenes/sticks.h"

namespace sim::hard {

Scene contradiction(const Values &values)
{
    Scene scene = scenes::pointsAt({middle, middle + Vec2{1.0, 0.0}, middle + Vec2{0.5, 1.0}});
    const std::vector<Stick> sticks = {{0, 1, 1.0}, {1, 2, 1.0}, {0, 2, 10.0}};
    scenes::add<Damping>(scene, values["damp"]);
    scenes::add<Sticks>(scene, sticks, 3, 10);
    return scene;
}

Scene stretchedChain(const Values &values)
{
    constexpr double span = 440.0;
    const int links = values.integer("links");
    const double spacing = span / links;
    scenes::StickFigure chain;
    for (int i = 0; i <= links; ++i)
        chain.places.push_back({middle.x - span / 2.0 + i * spacing, middle.y});
    chain.sticks = scenes::chainOfSticks(links, spacing / values["stretched"]);
    chain.pinned = {0, links};
    chain.gravity = values["gravity"];
    chain.damp = values["damp"];
    chain.passes = values.integer("passes");
    return scenes::fallingSticks(chain);
}

Scene noLengthStick(const Values &values)
{
    return scenes::fallingSticks({.places = {middle, middle, middle + Vec2{60.0, 0.0}},
                                  .sticks = {{0, 1, 0.0}, {1, 2, 60.0}},
                                  .pinned = {0},
                                  .gravity = values["gravity"],
                                  .damp = values["damp"],
                                  .passes = 20});
}

Scene fixedStick(const Values &values)
{
    return scenes::fallingSticks(
        {.places = {middle - Vec2{50.0, 0.0}, middle + Vec2{50.0, 0.0}, middle + Vec2{90.0, 0.0}},
         .sticks = {{0, 1, 50.0}, {1, 2, 40.0}},
         .pinned = {0, 1},
         .gravity = values["gravity"],
         .damp = values["damp"],
         .passes = 4});
}

}
