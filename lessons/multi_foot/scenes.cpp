#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/base/random.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace multi_foot {

namespace two_feet {

//! [two_feet]
Scene setUp(const Values &values)
{
    const int feet = 2;
    Scene scene = creature(feet);
    const int body = feet; // comes last
    scene.start.place(0, {310, 240});
    scene.start.place(1, {220, 180});

    std::vector<Link> links;
    links.push_back({0, body});
    links.push_back({body, 0});
    links.push_back({1, body});
    links.push_back({body, 1});
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [two_feet]

}

namespace any_number {

//! [any_number]
Scene setUp(const Values &values)
{
    int feet = values.integer("feet");
    Scene scene = creature(feet);
    const int body = feet; // comes last
    placeFeet(scene, {{300, 210}, {250, 230},
                      {280, 160}, {240, 190},
                      {310, 180}});

    std::vector<Link> links;
    for (int i = 0; i < feet; ++i) {
        links.push_back({i, body});
        links.push_back({body, i});
    }
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [any_number]

}

namespace grown_feet {

//! [grown_feet]
Scene setUp(const Values &values)
{
    int feet = values.integer("feet");
    Scene scene = creature(feet);
    const int body = feet; // comes last
    const auto seed = values.seed;
    for (int i = 0; i < feet; ++i) {
        double right = uniform(seed, 0, 2 * i);
        double down = uniform(seed, 0, 2 * i + 1);
        scene.start.place(i, {270 + 100 * right - 50,
                              200 + 100 * down - 50});
    }

    std::vector<Link> links;
    for (int i = 0; i < feet; ++i) {
        links.push_back({i, body});
        links.push_back({body, i});
    }
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [grown_feet]

}

}
