#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"

#include <numbers>

// Learners read these functions in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;
using std::numbers::pi;

namespace walking_gait {

namespace bones {

//! [bones]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeetOnHandle(2);
    const int body = 2; // comes last
    scene.start.place(0, {255, 260});
    scene.start.place(1, {285, 260});
    scene.start.place(body, {270, 200});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    add<LegSpring>(scene, legs, rule);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [bones]

}

namespace legs {

//! [legs]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeetOnHandle(2);
    const int body = 2; // comes last
    scene.start.place(0, {255, 260});
    scene.start.place(1, {285, 260});
    scene.start.place(body, {270, 200});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    add<LegSpring>(scene, legs, rule);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [legs]

}

namespace feet_below {

//! [feet_below]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeetOnHandle(2);
    const int body = 2; // comes last
    scene.start.place(0, {220, 350});
    scene.start.place(1, {320, 350});
    scene.start.place(body, {270, 300});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    rule.drop = values["drop"];
    rule.aim = Aim::below;
    add<LegSpring>(scene, legs, rule);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [feet_below]

}

namespace curved_legs {

//! [curved_legs]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeetOnHandle(2);
    const int body = 2; // comes last
    scene.start.place(0, {220, 350});
    scene.start.place(1, {320, 350});
    scene.start.place(body, {270, 300});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    rule.drop = values["drop"];
    rule.aim = Aim::below;
    add<LegSpring>(scene, legs, rule);

    double damp = values["damp"];
    add<Damping>(scene, damp);
    return scene;
}
//! [curved_legs]

}

namespace swing {

//! [swing]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeetOnHandle(2);
    const int body = 2; // comes last
    scene.start.place(0, {220, 350});
    scene.start.place(1, {320, 350});
    scene.start.place(body, {270, 300});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    rule.drop = values["drop"];
    rule.aim = Aim::swing;
    add<LegSpring>(scene, legs, rule);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [swing]

}

namespace body_pulled {

//! [body_pulled]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeet(2);
    const int body = 2; // comes last
    scene.start.place(0, {220, 350});
    scene.start.place(1, {320, 350});
    scene.start.place(body, {270, 300});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    rule.drop = values["drop"];
    rule.aim = Aim::swing;
    rule.reaction = Reaction::equal;
    add<LegSpring>(scene, legs, rule);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [body_pulled]

}

namespace ground {

//! [ground]
Scene setUp(const Values &values)
{
    Scene scene = creatureWithFeet(2);
    const int body = 2; // comes last
    const std::vector<int> feet = {0, 1};
    scene.start.place(0, {220, 350});
    scene.start.place(1, {320, 350});
    scene.start.place(body, {270, 300});

    std::vector<Leg> legs;
    legs.push_back({0, body, 0}); // left
    legs.push_back({1, body, pi}); // right
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    rule.drop = values["drop"];
    rule.aim = Aim::swing;
    rule.reaction = Reaction::equal;
    add<LegSpring>(scene, legs, rule);

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    Soil soil;
    soil.ground = values["ground"];
    soil.bounce = values["bounce"];
    int choice = values.whole("traction");
    soil.traction = Traction(choice);
    add<Ground>(scene, feet, soil);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [ground]

}

}
