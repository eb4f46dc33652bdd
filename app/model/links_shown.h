#pragma once

#include "lessons/api/view/view.h"
#include "sim/scene/effect.h"

namespace app {

/// Takes out of `look` each link (leg, stick, spring, limb, part of a chain, side of a skin or sheet) that a spring or stick of `listed`
/// stands for and none of those that `act` does: what is switched off is not drawn. A link that stands for no effect
/// stays.
void dropLinks(lessons::View &look, const std::vector<sim::EffectPtr> &listed,
               const std::vector<sim::EffectPtr> &acting);

}
