#include "scenes.h"

#include "lessons/api/creature.h"
#include "plan.h"
#include "sim/effects/breeze.h"
#include "sim/effects/damping.h"
#include "sim/effects/gait_clock.h"
#include "sim/effects/gravity.h"
#include "sim/effects/ground.h"
#include "sim/effects/push.h"
#include "sim/effects/ramp.h"
#include "sim/effects/room_limits.h"
#include "sim/effects/sticks.h"
#include "sim/effects/turn_round.h"

#include <numeric>

// Learners read this function in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace sandbox::build {

namespace {

/// The numbers of all points.
std::vector<int> allPoints(const Blueprint &plan)
{
    std::vector<int> all(plan.points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

}

//! [build]
Scene setUp(const Values &values)
{
    const Blueprint &plan = planOf(values);
    Scene scene = pointsOf(plan);
    const int count = scene.start.points();
    setClocks(scene, plan);

    if (!plan.springs.empty())
        add<Springs>(scene,
            springsOf(plan), count);
    int group = 0;
    for (const BuiltGait &gait : plan.gaits) {
        auto legs = legsOf(plan, group++);
        if (!legs.empty())
            add<LegSpring>(scene,
                legs, ruleOf(gait));
    }
    if (has(plan, "push"))
        add<Push>(scene, allPoints(plan),
            values["push"], values["distance"],
            Reaction::equal);
    if (has(plan, "gravity"))
        add<Gravity>(scene, values["gravity"]);
    if (has(plan, "breeze")) {
        Air air;
        air.wind = values["wind"];
        air.gusts = values["gusts"];
        add<Breeze>(scene, air, widths(plan),
            windClockOf(plan));
    }
    if (has(plan, "damping"))
        add<Damping>(scene, values["damp"]);

    if (!plan.sticks.empty())
        add<Sticks>(scene,
            sticksOf(plan), count,
            values.whole("iterations"));
    const Room room = roomOf(values);
    if (has(plan, "room"))
        add<RoomLimits>(scene, room,
            halfWidths(plan),
            values["friction"]);
    if (has(plan, "walls"))
        add<Walls>(scene, room,
            halfWidths(plan));
    if (has(plan, "ramp"))
        add<Ramp>(scene, rampOf(values),
            halfWidths(plan));
    if (has(plan, "ground")) {
        Soil soil;
        soil.ground = values["ground"];
        add<Ground>(scene, feetOf(plan), soil);
    }

    if (has(plan, "turn_round"))
        add<TurnRound>(scene, room,
            halfWidths(plan), clockOf(plan),
            matesOf(plan));
    if (hasClocks(plan, values))
        add<GaitClock>(scene, clockOf(plan));
    return scene;
}
//! [build]

}
