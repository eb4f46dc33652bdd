#pragma once

#include "sim/scene/scene.h"

#include <algorithm>

namespace lessons {

// What acts in a scene: an effect that is switched off is not among its effects, and nothing of it is drawn.

/// The first effect of a class that acts in `scene`; null where none does.
template <class Effect>
const Effect *effectOf(const sim::Scene &scene)
{
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *found = dynamic_cast<const Effect *>(effect.get()))
            return found;
    }
    return nullptr;
}

/// Whether any effect of this kind acts in `scene`.
inline bool hasEffectOfKind(const sim::Scene &scene, sim::EffectKind kind)
{
    return std::any_of(scene.effects.begin(), scene.effects.end(),
                       [kind](const sim::EffectPtr &effect) { return effect->kind() == kind; });
}

}
