#include "scenes.h"

#include "cases.h"
#include "lessons/api/creature.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace hard_cases {

namespace limit {

//! [limit]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.start.place(0, {290, 200});

    double k = values["k"];
    add<PointSpring>(scene, 0, centre, k);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [limit]

}

namespace runaway {

//! [runaway]
Scene setUp(const Values &values)
{
    Scene scene = pair();
    const int foot = 0, body = 1;
    scene.start.place(foot, {330, 260});

    std::vector<Link> links =
        {{foot, body}, {body, foot}};
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [runaway]

}

namespace many_feet {

//! [many_feet]
Scene setUp(const Values &values)
{
    const int feet = values.integer("feet");
    Scene scene = creature(feet);
    const int body = feet; // comes last
    placeFeet(scene, {}); // evenly round it
    scene.start.setVelocity(body, {2, 1});

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
//! [many_feet]

}

namespace one_place {

//! [one_place]
Scene setUp(const Values &values)
{
    const int feet = values.integer("feet");
    Scene scene = creature(feet);
    const int body = feet; // comes last
    // All of them stay where they are
    // made: in one place.

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
//! [one_place]

}

namespace stiff {

//! [stiff]
Scene setUp(const Values &values)
{
    const int feet = 3;
    Scene scene = creature(feet);
    const int body = feet; // comes last
    placeFeet(scene, {{322, 154}, {210, 170},
                      {265, 272}});

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
//! [stiff]

}

namespace contradiction {

//! [contradiction]
Scene setUp(const Values &values)
{
    Scene scene = scenes::pointsAt(
        {{260, 205}, {280, 205}, {270, 185}});

    double k = values["k"];
    double longest = values["longest"];
    if (values.integer("made_of") == 0) {
        std::vector<Link> two = {{0, 1}, {1, 0},
                                 {1, 2}, {2, 1}};
        add<RadialSpring>(scene, two, k, 20.0);
        std::vector<Link> third = {{0, 2}, {2, 0}};
        add<RadialSpring>(scene, third, k, longest);
    }

    double damp = values["damp"];
    add<Damping>(scene, damp);

    if (values.integer("made_of") == 1) {
        std::vector<Stick> sticks =
            {{0, 1, 20}, {1, 2, 20},
             {0, 2, longest}};
        add<Sticks>(scene, sticks, 3);
    }
    return scene;
}
//! [contradiction]

}

namespace long_run {

//! [long_run]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.start.place(0, {390, 200});

    double k = values["k"];
    add<PointSpring>(scene, 0, centre, k);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [long_run]

}

namespace torture {

//! [torture]
Scene setUp(const Values &values)
{
    HardCase hard =
        caseNumber(values.integer("case"));
    Values own = hard.script.values;
    double k = values["k"];
    if (k > 0 && own.has("k"))
        own.set("k", k);
    return hard.script.build(own);
}
//! [torture]

}

}
