#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/damping.h"
#include "sim/effects/radial_spring.h"
#include "sim/random.h"

using namespace sim;
using namespace lessons;

namespace multi_foot {

namespace two_feet {

//! [two_feet]
Scene setUp(const Values &values)
{
    const int feet = 2;
    Scene scene = creatureWithFeet(feet);
    const int body = feet; // the feet are points 0 and 1
    scene.start.place(0, {310, 240});
    scene.start.place(1, {220, 180});

    std::vector<Link> links;
    links.push_back({0, body});
    links.push_back({body, 0});
    links.push_back({1, body});
    links.push_back({body, 1});
    const double k = values["k"];
    const double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    const double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [two_feet]

}

namespace any_number {

//! [any_number]
Scene setUp(const Values &values)
{
    const int feet = values.whole("feet");
    Scene scene = creatureWithFeet(feet);
    const int body = feet; // the feet are points 0, 1, 2...
    placeFeet(scene, {{300, 210}, {250, 230}, {280, 160}, {240, 190}, {310, 180}});

    std::vector<Link> links;
    for (int i = 0; i < feet; ++i) {
        links.push_back({i, body});
        links.push_back({body, i});
    }
    const double k = values["k"];
    const double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    const double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [any_number]

}

namespace grown_feet {

//! [grown_feet]
Scene setUp(const Values &values)
{
    const int feet = values.whole("feet");
    Scene scene = creatureWithFeet(feet);
    const int body = feet; // the feet are points 0, 1, 2...
    for (int i = 0; i < feet; ++i) {
        const double right = 100 * uniform(values.seed, 0, 2 * i) - 50;
        const double down = 100 * uniform(values.seed, 0, 2 * i + 1) - 50;
        scene.start.place(i, {270 + right, 200 + down});
    }

    std::vector<Link> links;
    for (int i = 0; i < feet; ++i) {
        links.push_back({i, body});
        links.push_back({body, i});
    }
    const double k = values["k"];
    const double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    const double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [grown_feet]

}

}
