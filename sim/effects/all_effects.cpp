#include "sim/effects/all_effects.h"

#include "sim/scene/blueprint_draft.h"

#include <algorithm>

/// Every effect, by the name of its description. Those that a learner can choose act in this order.
// clang-format off
#define EFFECTS(ONE) \
    ONE(body_spring) \
    ONE(leg_spring) \
    ONE(motor) \
    ONE(offset_spring) \
    ONE(point_spring) \
    ONE(radial_spring) \
    ONE(springs) \
    ONE(torsion) \
    ONE(push) \
    ONE(charges) \
    ONE(gravity) \
    ONE(breeze) \
    ONE(damping) \
    ONE(split_damping) \
    ONE(angle_limits) \
    ONE(area_stick) \
    ONE(soft_sticks) \
    ONE(sticks) \
    ONE(room) \
    ONE(walls) \
    ONE(ramp) \
    ONE(ground) \
    ONE(anticipation) \
    ONE(gait_clock) \
    ONE(gust) \
    ONE(joints) \
    ONE(pointer) \
    ONE(return_to_rest) \
    ONE(steering) \
    ONE(turn_round) \
    ONE(turn_to_pointer) \
    ONE(wind)
// clang-format on

namespace sim {

namespace descriptions {
#define DECLARE(name) extern const EffectDescription name;
EFFECTS(DECLARE)
#undef DECLARE
}

EffectList allEffects()
{
#define ADDRESS(name) &descriptions::name,
    static constexpr const EffectDescription *all[] = {EFFECTS(ADDRESS)};
#undef ADDRESS
    return all;
}

const EffectDescription *findDescription(EffectList known, const std::string &id)
{
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const EffectDescription *one) { return one->id == id; });
    return found == known.end() ? nullptr : *found;
}

std::string purposeOf(const Effect &effect)
{
    const EffectDescription *found = findDescription(allEffects(), effect.id());
    return found ? found->purpose : std::string();
}

ChosenEffects chosenEffects(EffectList known, const Blueprint &plan, const Values &values)
{
    ChosenEffects chosen;
    for (const EffectDescription *one : known) {
        if (!one->make || !hasEffect(plan, one->id))
            continue;
        const EffectPtr effect = one->make(plan, values);
        const bool pulls = as<Force>(*effect) || as<Torque>(*effect) || as<Drag>(*effect);
        (pulls ? chosen.beforeMove : chosen.afterMove).push_back(effect);
    }
    return chosen;
}

}
