#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

using namespace sim;
using namespace lessons;

namespace single_spring {

namespace drag {

//! [drag]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.start.place(foot, {420, 120});

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [drag]

}

namespace fixed_centre {

//! [fixed_centre]
Scene setUp(const Values &values)
{
    Scene scene = singleFoot();
    scene.start.place(foot, {420, 120});

    Vec2 centre;
    centre.x = values["centre_x"];
    centre.y = values["centre_y"];
    double k = values["k"];
    add<PointSpring>(scene, foot, centre, k);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [fixed_centre]

}

namespace moving_body {

//! [moving_body]
Scene setUp(const Values &values)
{
    Scene scene = pairOnHandle();
    scene.start.place(foot, {100, 300});

    std::vector<Link> links = {{foot, body}};
    double k = values["k"];
    add<BodySpring>(scene, links, k);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [moving_body]

}

namespace offset {

//! [offset]
Scene setUp(const Values &values)
{
    Scene scene = pairOnHandle();
    scene.start.place(foot, {100, 300});

    std::vector<Link> links = {{foot, body}};
    double k = values["k"];
    double offset = values["offset"];
    add<OffsetSpring>(scene, links, k, offset);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [offset]

}

namespace radial {

//! [radial]
Scene setUp(const Values &values)
{
    Scene scene = pairOnHandle();
    scene.start.place(foot, {300, 230});

    std::vector<Link> links = {{foot, body}};
    double k = values["k"];
    double radius = values["radius"];
    add<RadialSpring>(scene, links, k, radius);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [radial]

}

}
