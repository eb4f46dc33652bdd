#include "sim/effects/all_effects.h"

#include "sim/scene/blueprint_draft.h"

#include <algorithm>

/// Calls the macro X with the name of every description. The effects that a learner can choose act in this
/// order.
// clang-format off
#define EFFECTS(X) \
    X(body_spring) \
    X(leg_spring) \
    X(motor) \
    X(offset_spring) \
    X(point_spring) \
    X(radial_spring) \
    X(springs) \
    X(torsion) \
    X(push) \
    X(charges) \
    X(gravity) \
    X(breeze) \
    X(rule) \
    X(damping) \
    X(split_damping) \
    X(angle_limits) \
    X(area_stick) \
    X(soft_sticks) \
    X(sticks) \
    X(room) \
    X(walls) \
    X(ramp) \
    X(ground) \
    X(anticipation) \
    X(gait_clock) \
    X(gust) \
    X(joints) \
    X(pointer) \
    X(return_to_rest) \
    X(steering) \
    X(turn_round) \
    X(turn_to_pointer) \
    X(wind)
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
    const auto found = std::find_if(known.begin(), known.end(), [&](const EffectDescription *description) {
        return description->id == id;
    });
    return found == known.end() ? nullptr : *found;
}

std::string purposeOf(const Effect &effect)
{
    const EffectDescription *found = findDescription(allEffects(), effect.id());
    return found ? found->purpose : std::string();
}

ChosenEffects chosenEffects(EffectList known, const Blueprint &blueprint, const Values &values)
{
    ChosenEffects chosen;
    for (const EffectDescription *description : known) {
        if (!description->make || !hasEffect(blueprint, description->id))
            continue;
        const EffectPtr effect = description->make(blueprint, values);
        const bool actsBeforeMove = as<Force>(*effect) || as<Torque>(*effect) || as<Drag>(*effect);
        (actsBeforeMove ? chosen.beforeMove : chosen.afterMove).push_back(effect);
    }
    return chosen;
}

}
