#include "scenes.h"

#include "lessons/api/creature.h"
#include "sim/effects/constraints/angle_limits.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/room_limits.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/pointer.h"
#include "sim/effects/fields/gravity.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "sim/scenes/points.h"

#include <algorithm>

using namespace sim;
using namespace lessons;

namespace rigid_constraint {

namespace {

Scene pointsWith(Motion motion, const Values &values, int count)
{
    const auto points = static_cast<std::size_t>(values.points.value_or(count));
    Scene scene = scenes::pointsAt(std::vector<Vec2>(points, {240.0, 165.0}));
    scene.groups.front().motion = motion;
    return scene;
}

}

Scene loosePoints(const Values &values, int count)
{
    return pointsWith(Motion::prescribed, values, count);
}

Scene movingPoints(const Values &values, int count)
{
    return pointsWith(Motion::byVelocity, values, count);
}

void placePoints(Scene &scene, const std::vector<Vec2> &positions)
{
    const int count = std::min(scene.start.pointCount(), static_cast<int>(positions.size()));
    for (int i = 0; i < count; ++i)
        scene.start.place(i, positions[static_cast<std::size_t>(i)]);
}

Stick stickBetween(const std::vector<Vec2> &positions, int a, int b)
{
    const Vec2 difference = positions[static_cast<std::size_t>(b)] - positions[static_cast<std::size_t>(a)];
    return {a, b, length(difference), 0.5};
}

void addSticks(Scene &scene, const Values &values, const std::vector<Stick> &sticks, int iterations)
{
    add<Sticks>(scene, values.sticks.value_or(sticks), scene.start.pointCount(), iterations);
}

Eigen::ArrayXd boxHalfWidths(const Scene &scene)
{
    return Eigen::ArrayXd::Constant(scene.start.pointCount(), jointRadius);
}

Eigen::ArrayXd ragdollHalfWidths(const Scene &scene)
{
    Eigen::ArrayXd half = boxHalfWidths(scene);
    if (half.rows() > 0)
        half[0] = headRadius;
    return half;
}

// Learners read the functions below in a narrow panel.
// clang-format off

namespace pair {

//! [pair]
Scene setUp(const Values &values)
{
    Scene scene = loosePoints(values, 2);
    add<CarriedByPointer>(scene, 0);

    double length = values["length"];
    std::vector<Stick> sticks;
    sticks.push_back({0, 1, length, 0.5});
    addSticks(scene, values, sticks);
    return scene;
}
//! [pair]

}

namespace shared_error {

//! [shared_error]
Scene setUp(const Values &values)
{
    Scene scene = loosePoints(values, 2);
    add<CarriedByPointer>(scene, 0);

    double length = values["length"];
    double share = values["share"];
    std::vector<Stick> sticks;
    sticks.push_back({0, 1, length, share});
    addSticks(scene, values, sticks);
    return scene;
}
//! [shared_error]

}

namespace triangle {

//! [triangle]
Scene setUp(const Values &values)
{
    Scene scene = loosePoints(values, 3);
    add<CarriedByPointer>(scene, 0);

    double length = values["length"];
    std::vector<Stick> sticks;
    sticks.push_back({0, 1, length, 0.5});
    sticks.push_back({1, 2, length, 0.5});
    sticks.push_back({0, 2, length, 0.5});
    addSticks(scene, values, sticks);
    return scene;
}
//! [triangle]

}

namespace list {

//! [list]
Scene setUp(const Values &values)
{
    int points = values.integer("triangles") + 2;
    Scene scene = loosePoints(values, points);
    add<CarriedByPointer>(scene, 0);

    double length = values["length"];
    std::vector<Vec2> places;
    std::vector<Stick> sticks;
    for (int i = 0; i < points; ++i) {
        double high = i % 2 ? 0.866 * length : 0;
        places.push_back({120 + i * length / 2,
                          230 - high});
        if (i >= 1) // to the one before
            sticks.push_back(
                {i - 1, i, length, 0.5});
        if (i >= 2) // and the one before that
            sticks.push_back(
                {i - 2, i, length, 0.5});
    }
    placePoints(scene, places);
    addSticks(scene, values, sticks);
    return scene;
}
//! [list]

}

namespace verlet {

//! [verlet]
Scene setUp(const Values &values)
{
    Scene scene = movingPoints(values, 4);
    std::vector<Vec2> places = {
        {100, 150}, {170, 150},
        {170, 220}, {100, 220}};
    placePoints(scene, places);
    scene.start.velocity.col(0) = 7;
    if (!values.points)
        scene.start.setVelocity(0, {7, -8}); // a spin

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);
    double damp = values["damp"];
    add<Damping>(scene, damp);

    std::vector<Stick> sticks;
    for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b)
            sticks.push_back(
                stickBetween(places, a, b));
    int iterations = values.integer("iterations");
    addSticks(scene, values, sticks, iterations);

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = values["floor"];
    double friction = values["friction"];
    add<RoomLimits>(scene, room,
        boxHalfWidths(scene), friction);
    return scene;
}
//! [verlet]

}

namespace ragdoll {

//! [ragdoll]
Scene setUp(const Values &values)
{
    Scene scene = movingPoints(values, 12);
    std::vector<Vec2> places = {
        {270, 95},              // 0: head
        {248, 130}, {292, 130}, // 1, 2: shoulders
        {270, 195},             // 3: hip
        {222, 160}, {205, 195}, // 4, 5: left arm
        {318, 160}, {335, 195}, // 6, 7: right arm
        {255, 245}, {247, 295}, // 8, 9: left leg
        {285, 245}, {293, 295}, // 10, 11: right leg
    };
    placePoints(scene, places);

    double gravity = values["gravity"];
    add<Gravity>(scene, gravity);
    double damp = values["damp"];
    add<Damping>(scene, damp);

    bool limited = values["joint_limits"] == 1;
    if (limited && !values.points) {
        std::vector<AngleLimit> limits = {
            {1, 3, 2, 20, 60}, // not inside out
            {2, 1, 4, 80, 300}, {1, 2, 6, 60, 280},
            {1, 4, 5, 40, 320}, {2, 6, 7, 40, 320},
            {1, 3, 8, 150, 290},
            {2, 3, 10, 70, 210},
            {3, 8, 9, 60, 300},
            {3, 10, 11, 60, 300}};
        add<AngleLimits>(scene, limits);
    }

    std::vector<Stick> sticks;
    const int ends[][2] = {
        {1, 2}, {1, 3}, {2, 3},  // torso
        {0, 1}, {0, 2}, {0, 3},  // head, braced
        {1, 4}, {4, 5},  {2, 6}, {6, 7},
        {3, 8}, {8, 9}, {3, 10}, {10, 11}};
    for (auto [a, b] : ends)
        sticks.push_back(
            stickBetween(places, a, b));
    int iterations = values.integer("iterations");
    addSticks(scene, values, sticks, iterations);

    Room room;
    room.left = values["left"];
    room.right = values["right"];
    room.floor = values["floor"];
    double friction = values["friction"];
    add<RoomLimits>(scene, room,
        ragdollHalfWidths(scene), friction);
    return scene;
}
//! [ragdoll]

}

}
