#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/drivers/steering.h"
#include "sim/effects/drivers/turn_round.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <cmath>
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
    Scene scene = creatureOnHandle(2);
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
    Scene scene = creatureOnHandle(2);
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
    Scene scene = creatureOnHandle(2);
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
    Scene scene = creatureOnHandle(2);
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
    Scene scene = creatureOnHandle(2);
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
    Scene scene = creature(2);
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
    Scene scene = creature(2);
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

    GroundPlane plane;
    plane.ground = values["ground"];
    plane.bounce = values["bounce"];
    int choice = values.integer("traction");
    plane.traction = Traction(choice);
    add<Ground>(scene, feet, plane);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [ground]

}

namespace more_feet {

//! [more_feet]
Scene setUp(const Values &values)
{
    int count = values.integer("feet");
    Scene scene = creature(count);
    const int body = count; // comes last
    scene.start.place(body, {270, 300});

    std::vector<int> feet;
    std::vector<Leg> legs;
    double spread =
        values["spread"] / 360 * 2 * pi;
    for (int i = 0; i < count; ++i) {
        double angle = spread * i / count;
        legs.push_back({i, body, angle});
        feet.push_back(i);
        scene.start.place(i, belowTarget(
            {270, 300}, angle, 50, 50));
    }
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

    GroundPlane plane;
    plane.ground = values["ground"];
    plane.bounce = values["bounce"];
    int choice = values.integer("traction");
    plane.traction = Traction(choice);
    add<Ground>(scene, feet, plane);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [more_feet]

}

namespace steering {

//! [steering]
Scene setUp(const Values &values)
{
    Scene scene = creature(2);
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

    GroundPlane plane;
    plane.ground = values["ground"];
    plane.bounce = values["bounce"];
    int choice = values.integer("traction");
    plane.traction = Traction(choice);
    add<Ground>(scene, feet, plane);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;

    SteeringLimits limits;
    limits.top = values["top"];
    limits.change = values["change"];
    add<Steering>(scene, 0, body, limits);
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [steering]

}

namespace walls {

//! [walls]
Scene setUp(const Values &values)
{
    Scene scene = creature(2);
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

    GroundPlane plane;
    plane.ground = values["ground"];
    plane.bounce = values["bounce"];
    int choice = values.integer("traction");
    plane.traction = Traction(choice);
    add<Ground>(scene, feet, plane);

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = INFINITY; // no floor
    room.bounce = 0;
    const auto half = halfWidths(scene);
    add<Walls>(scene, room, half);

    double speed = values["speed"];
    scene.start.gait.setZero(1);
    scene.start.gaitSpeed.setZero(1);
    scene.start.gaitSpeed[0] = speed;

    SteeringLimits limits;
    limits.top = values["top"];
    limits.change = values["change"];
    add<Steering>(scene, 0, body, limits);
    const std::vector<int> clockOf(3, 0);
    if (values.integer("at_wall") == 0)
        add<TurnRound>(scene, room, half,
                       clockOf);
    add<GaitClock>(scene); // comes last
    return scene;
}
//! [walls]

}

namespace company {

//! [company]
Scene inARow(int count, double speed)
{
    Scene scene = crowd(count, 2);
    scene.start.gait.setZero(count);
    scene.start.gaitSpeed.setZero(count);
    for (int i = 0; i < count; ++i) {
        double way = i - (count - 1) / 2.0;
        double x = 270 + way * 400 / count;
        int left = 3 * i;
        int right = left + 1;
        int body = left + 2;
        scene.start.place(left, {x - 50, 350});
        scene.start.place(right, {x + 50, 350});
        scene.start.place(body, {x, 300});
        // towards the middle, out of step
        scene.start.gaitSpeed[i] =
            way > 0 ? -speed : speed;
        scene.start.gait[i] = i;
    }
    return scene;
}

Scene setUp(const Values &values)
{
    int count = values.integer("creatures");
    double speed = values["speed"];
    Scene scene = inARow(count, speed);
    std::vector<int> feet, bodies, clockOf;
    std::vector<Leg> legs;
    for (int i = 0; i < count; ++i) {
        int left = 3 * i;
        int right = left + 1;
        int body = left + 2;
        legs.push_back({left, body, 0, i});
        legs.push_back({right, body, pi, i});
        feet.push_back(left);
        feet.push_back(right);
        bodies.push_back(body);
        clockOf.insert(clockOf.end(), 3, i);
    }
    LegRule rule;
    rule.k = values["k"];
    rule.leg = values["leg"];
    rule.drop = values["drop"];
    rule.aim = Aim::swing;
    rule.reaction = Reaction::equal;
    add<LegSpring>(scene, legs, rule);

    double push = values["push"];
    double distance = values["distance"];
    int felt = values.integer("felt_by");
    add<Push>(scene, bodies, push, distance,
        felt == 0 ? Reaction::equal
                  : Reaction::none);

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);

    double damp = values["damp"];
    add<Damping>(scene, damp);

    GroundPlane plane;
    plane.ground = values["ground"];
    plane.bounce = values["bounce"];
    int choice = values.integer("traction");
    plane.traction = Traction(choice);
    add<Ground>(scene, feet, plane);

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = INFINITY; // no floor
    room.bounce = 0;
    const auto half = halfWidths(scene);
    add<Walls>(scene, room, half);
    if (values.integer("at_wall") == 0)
        add<TurnRound>(scene, room, half,
                       clockOf);
    add<GaitClock>(scene, clockOf);
    return scene;
}
//! [company]

}

}
