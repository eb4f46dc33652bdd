#include "scenes.h"

#include "attraction.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <cmath>
#include <memory>

//! [circle]
sim::Scene setUp(const sim::Values &values)
{
    double strength = values["strength"];
    double distance = 120.0;

    sim::Scene scene;
    scene.names = {"moon"};
    scene.groups = {{"points", {0, 1}}};
    scene.start = sim::State::ofPoints(1);
    scene.start.place(0, planet + sim::Vec2{distance, 0.0});
    scene.start.velocity(0, 1) = std::sqrt(strength / distance); // of a circle
    scene.effects = {std::make_shared<Attraction>(planet, strength)};
    return scene;
}
//! [circle]
