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

/// Returns what `effect` is for: one sentence for a learner, in English; see SIM_TEXT. Empty for an effect that
/// allEffects() does not have.
std::string purposeOf(const Effect &effect);

/// The effects that were chosen for a built scene, in the order in which they act.
struct ChosenEffects
{
    std::vector<EffectPtr>
        beforeMove; ///< those that act before points are put right: forces, torques and drags
    std::vector<EffectPtr> afterMove;
};

/// Makes those effects of `known` that `plan` lists. `values` has every setting of them.
ChosenEffects chosenEffects(EffectList known, const Blueprint &plan, const Values &values);

}
