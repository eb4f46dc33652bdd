#pragma once

#include "sim/effects/effect_description.h"

#include <vector>

namespace sim {

/// Descriptions of effects, in the order in which the effects act.
using EffectList = std::span<const EffectDescription *const>;

/// Returns the description of every effect.
EffectList allEffects();

/// Returns the description with the id `id`, or null if `known` has none.
const EffectDescription *findDescription(EffectList known, const std::string &id);

/// Returns the purpose of `effect`: one sentence for a learner, in English; see SIM_TEXT. Empty if
/// allEffects() has no description with the id of the effect.
std::string purposeOf(const Effect &effect);

/// The effects that a learner chose for a blueprint, in the order in which they act.
struct ChosenEffects
{
    std::vector<EffectPtr> beforeMove; ///< forces, torques and drags
    std::vector<EffectPtr> afterMove;  ///< all others, such as constraints and contacts
};

/// Creates the effects of `known` that `blueprint` lists. `values` has every parameter of these effects.
ChosenEffects chosenEffects(EffectList known, const Blueprint &blueprint, const Values &values);

}
