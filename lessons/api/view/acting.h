#pragma once

#include "sim/scene/scene.h"

#include <algorithm>

namespace lessons {

// Effects that are switched off are not in Scene::effects, so nothing of them is drawn.

/// Returns the first effect of a class that acts in `scene`. Null if there is none.
template <class Effect>
const Effect *effectOf(const sim::Scene &scene)
{
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *found = dynamic_cast<const Effect *>(effect.get()))
            return found;
    }
    return nullptr;
}

/// Returns whether any effect of this kind acts in `scene`.
inline bool hasEffectOfKind(const sim::Scene &scene, sim::EffectKind kind)
{
    return std::any_of(scene.effects.begin(), scene.effects.end(),
                       [kind](const sim::EffectPtr &effect) { return effect->kind() == kind; });
}

}
