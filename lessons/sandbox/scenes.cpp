#include "scenes.h"

#include "lessons/api/creature.h"
#include "plan.h"
#include "sim/effects/all_effects.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/drivers/gait_clock.h"

// Learners read this function in a narrow panel.
// clang-format off

using namespace sim;
using namespace lessons;

namespace sandbox::build {

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
    // the effects that are switched on
    auto chosen = chosenEffects(
        allEffects(), plan, values);
    for (EffectPtr &one : chosen.pulls)
        scene.effects.push_back(one);
    if (!plan.sticks.empty())
        add<Sticks>(scene,
            sticksOf(plan), count,
            values.whole("iterations"));
    for (EffectPtr &one : chosen.rest)
        scene.effects.push_back(one);
    if (hasClocks(plan, values))
        add<GaitClock>(scene, clockOf(plan));
    return scene;
}
//! [build]

}
