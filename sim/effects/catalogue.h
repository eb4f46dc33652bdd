#pragma once

#include "sim/effects/description.h"

#include <vector>

namespace sim {

using Catalogue = std::span<const Description *const>;

/// Every effect there is.
Catalogue catalogue();

/// The description with that id; null where there is none.
const Description *findDescription(Catalogue known, const std::string &id);

/// What `effect` is there for: one sentence for a learner, in English; see SIM_TEXT. Empty for one that is not in the
/// catalogue.
std::string purposeOf(const Effect &effect);

/// The effects of a catalogue that were chosen for a built scene, in the order in which they act.
struct ChosenEffects
{
    std::vector<EffectPtr> pulls; ///< those that act before points are put right: forces, torques and drags
    std::vector<EffectPtr> rest;
};

/// Makes those effects of `known` that `plan` lists. `values` has every setting of them.
ChosenEffects chosenEffects(Catalogue known, const Blueprint &plan, const Values &values);

}
