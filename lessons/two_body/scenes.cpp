#include "scenes.h"

#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace two_body {

namespace mutual {

//! [mutual]
Scene setUp(const Values &values)
{
    Scene scene = pair();
    scene.start.place(foot, {330, 260});

    std::vector<Link> links = {{foot, body},
                               {body, foot}};
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}

View look(const Scene &scene)
{
    View look = creatureView(scene);
    look.springs = actingSprings(scene);
    return look;
}
//! [mutual]

}

namespace leg_line {

//! [leg_line]
Scene setUp(const Values &values)
{
    Scene scene = pair();
    scene.start.place(foot, {330, 260});

    std::vector<Link> links = {{foot, body},
                               {body, foot}};
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}

View look(const Scene &scene)
{
    View look = creatureView(scene);
    look.springs = actingSprings(scene);
    look.legs.push_back({body, foot});
    return look;
}
//! [leg_line]

}

}
