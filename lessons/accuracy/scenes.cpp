#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/base/random.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <algorithm>
#include <cmath>

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace accuracy {

namespace big_step {

//! [big_step]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.start.place(foot, {400, 200});

    double k = values["k"];
    add<PointSpring>(scene, foot, centre, k);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [big_step]

}

namespace energy {

//! [energy]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.start.place(foot, {370, 200});

    double k = values["k"];
    add<PointSpring>(scene, foot, centre, k);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [energy]

}

namespace halve {

//! [halve]
Scene setUp(const Values &values)
{
    const int feet = 5;
    Scene scene = creature(feet);
    const int body = feet; // comes last
    placeFeet(scene, {{322, 154}, {210, 170},
                      {225, 252}, {330, 230},
                      {275, 272}});
    scene.start.setVelocity(0, {2, 3});
    scene.start.setVelocity(1, {-1, 3});

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
//! [halve]

}

namespace adapt {

//! [adapt]
Scene setUp(const Values &values)
{
    Scene scene = pairOnHandle();
    const int body = 1;
    scene.start.place(foot, {440, 200});
    scene.start.setVelocity(foot, {0, 0.2});

    std::vector<Link> links = {{foot, body}};
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [adapt]

}

namespace bounce {

//! [bounce]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.names = {SIM_TEXT("ball")};
    scene.start.place(foot, {60, 130});
    scene.start.setVelocity(foot, {1.6, 0});

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = values["floor"];
    room.bounce = values["bounce"];
    Eigen::ArrayXd half(1);
    half << ballRadius;
    add<Walls>(scene, room, half);
    return scene;
}
//! [bounce]

}

namespace budget {

//! [budget]
Scene setUp(const Values &values)
{
    const int feet = 3;
    Scene scene = creature(feet);
    const int body = feet; // comes last
    placeFeet(scene, {{322, 154}, {210, 170},
                      {265, 272}});
    scene.start.setVelocity(0, {2, 3});
    scene.start.setVelocity(1, {-1, 3});

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
//! [budget]

}

namespace crowd {

namespace {

constexpr double usualCount = 15.0; ///< creatures for which the room of the other lessons is large enough

/// Returns how many times as wide and high the room is as that of the other lessons.
double widening(int count)
{
    return std::max(1.0, std::sqrt(count / usualCount));
}

}

Room roomFor(int count)
{
    const double half = 250.0 * widening(count);
    return {270.0 - half, 270.0 + half, 380.0, 1.0};
}

double heightFor(int count)
{
    return 360.0 * widening(count);
}

//! [crowd]
Scene setUp(const Values &values)
{
    int count = values.integer("creatures");
    Scene scene = crowdByParts(count, feet);
    Room room = roomFor(count);
    double high = heightFor(count);
    const auto seed = values.seed;
    const auto one = [&](int frame, int i) {
        return uniform(seed, frame, i);
    };
    // all bodies come first
    for (int i = 0; i < count; ++i) {
        double right = one(0, 2 * i);
        double up = one(0, 2 * i + 1);
        double wide = room.right - room.left;
        scene.start.place(i,
            {room.left + 60 + right * (wide - 120),
             room.floor - 60 - up * (high - 120)});
    }
    // then all first feet, all second feet...
    std::vector<Link> links;
    for (int f = 1; f <= feet; ++f) {
        for (int i = 0; i < count; ++i) {
            int foot = f * count + i;
            double right = one(f, 2 * i);
            double down = one(f, 2 * i + 1);
            scene.start.place(foot,
                scene.start.positionOf(i) +
                Vec2{100 * right - 50,
                     100 * down - 50});
            links.push_back({foot, i});
            links.push_back({i, foot});
        }
    }
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    room.bounce = values["bounce"];
    add<Walls>(scene, room, halfWidths(scene));
    return scene;
}
//! [crowd]

}

}
