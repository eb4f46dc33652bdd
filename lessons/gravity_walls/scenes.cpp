#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/base/random.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace gravity_walls {

namespace walls {

//! [walls]
Scene setUp(const Values &values)
{
    int feet = values.integer("feet");
    Scene scene = creature(feet);
    const int body = feet; // comes last
    scene.start.place(body, {420, 320});
    scene.start.setVelocity(body, {14, 9});
    placeFeet(scene, {{450, 310}, {400, 330},
                      {430, 260}, {390, 290},
                      {460, 280}});

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

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = values["floor"];
    room.bounce = values["bounce"];
    add<Walls>(scene, room, halfWidths(scene));
    return scene;
}
//! [walls]

}

namespace gravity {

//! [gravity]
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

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = values["floor"];
    room.bounce = values["bounce"];
    add<Walls>(scene, room, halfWidths(scene));
    return scene;
}
//! [gravity]

}

}
