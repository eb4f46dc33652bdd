#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drags/split_damping.h"
#include "sim/effects/drivers/motor.h"
#include "swimmer.h"

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace codeling {

using sim::Points; // not that of lessons

namespace motor {

//! [motor]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);

    double keep = values["keep"];
    add<Damping>(scene, keep, Points{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);
    return scene;
}
//! [motor]

}

namespace orientation {

//! [orientation]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Inertia::none);

    double keep = values["keep"];
    add<Damping>(scene, keep, Points{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double rest = values["rest_length"];
    const double share = 0; // none for the lead
    std::vector<Stick> spine = {
        {lead, tail, rest, share}};
    add<Sticks>(scene, spine,
                scene.start.points());
    return scene;
}
//! [orientation]

}

namespace anticipation {

//! [anticipation]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Inertia::none);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, Points{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double rest = values["rest_length"];
    const double share = 0; // none for the lead
    std::vector<Stick> spine = {
        {lead, tail, rest, share}};
    add<Sticks>(scene, spine,
                scene.start.points());
    return scene;
}
//! [anticipation]

}

namespace squash_stretch {

//! [squash_stretch]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Inertia::some);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, Points{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double along = values["along"];
    double across = values["across"];
    add<SplitDamping>(scene, tail, lead,
                      along, across);

    std::vector<SoftStick> spine = {
        {lead, tail, values["min_length"],
         values["rest_length"],
         values["max_length"]}};
    Strengths strength;
    strength.soft = values["soft"];
    strength.hard = values["hard"];
    add<SoftSticks>(scene, spine, strength);
    return scene;
}
//! [squash_stretch]

}

namespace volume {

//! [volume]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Inertia::some);
    addSides(scene);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, Points{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double along = values["along"];
    double across = values["across"];
    add<SplitDamping>(scene, tail, lead,
                      along, across);

    std::vector<SoftStick> soft = {
        {lead, tail, values["min_length"],
         values["rest_length"],
         values["max_length"]}};
    for (SoftStick one : sideSticks(values))
        soft.push_back(one); // two a side
    Strengths strength;
    strength.soft = values["soft"];
    strength.hard = values["hard"];
    add<SoftSticks>(scene, soft, strength);

    double area = restArea(values);
    add<AreaStick>(scene, corners, area,
                   shortestSpine);
    return scene;
}
//! [volume]

}

namespace tentacles {

//! [tentacles]
Scene setUp(const Values &values)
{
    Scene scene = swimmer(values);
    addTail(scene, values, Inertia::some);
    addSides(scene);
    int chains = values.whole("tentacles");
    int each = values.whole("links");
    std::vector<Stick> links =
        addTentacles(scene, chains, each);

    double part = values["anticipation"];
    add<Anticipation>(scene, lead, part);

    double keep = values["keep"];
    add<Damping>(scene, keep, Points{lead, 1});
    double k = values["k"];
    double dt = values["dt"];
    add<Motor>(scene, lead, k, dt);

    double along = values["along"];
    double across = values["across"];
    add<SplitDamping>(scene, tail, lead,
                      along, across);
    double water = values["water"];
    add<Damping>(scene, water,
        Points{firstOfTentacles, chains * each});

    std::vector<SoftStick> soft = {
        {lead, tail, values["min_length"],
         values["rest_length"],
         values["max_length"]}};
    for (SoftStick one : sideSticks(values))
        soft.push_back(one); // two a side
    Strengths strength;
    strength.soft = values["soft"];
    strength.hard = values["hard"];
    add<SoftSticks>(scene, soft, strength);

    double area = restArea(values);
    add<AreaStick>(scene, corners, area,
                   shortestSpine);
    add<Sticks>(scene, links,
                scene.start.points());
    return scene;
}
//! [tentacles]

}

}
