#pragma once

#include "lessons/api/view/view.h"
#include "sim/scene/effect.h"

namespace app {

/// Removes each link from `view` for which `listed` has a spring or stick but `acting` has none. Effects that are
/// switched off are therefore not drawn. A link is a leg, stick, spring, limb, part of a chain, or side of a skin
/// or sheet. A link that represents no effect stays. Removes the links of the rule if it is switched off.
void dropLinks(lessons::View &view, const std::vector<sim::EffectPtr> &listed,
               const std::vector<sim::EffectPtr> &acting);

}
