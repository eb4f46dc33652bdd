#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/damping.h"
#include "sim/effects/gravity.h"
#include "sim/effects/radial_spring.h"
#include "sim/random.h"

using namespace sim;
using namespace lessons;

namespace gravity_walls {

namespace walls {

//! [walls]
Scene setUp(const Values &values)
{
    const int feet = values.whole("feet");
    Scene scene = creatureWithFeet(feet);
    const int body = feet; // the feet are points 0, 1, 2...
    scene.start.place(body, {420, 320});
    scene.start.push(body, {14, 9});
    placeFeet(scene, {{450, 310}, {400, 330}, {430, 260}, {390, 290}, {460, 280}});

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

    const double gravity = values["gravity"];
    add<Gravity>(scene, gravity);

    const double damp = values["damp"];
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
