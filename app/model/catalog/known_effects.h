#pragma once

#include "app/model/catalog/lesson_library.h"
#include "sim/scene/effect.h"

#include <functional>

namespace app {

/// An effect in the scene of a lesson.
struct KnownEffect
{
    std::string id;
    std::string title; ///< in English; see SIM_TEXT
    std::string purpose;
    sim::EffectKind kind = sim::EffectKind::motion;
    QString lesson; ///< the title of the first lesson that has it
};

/// Returns the effects of all steps' scenes in the order of the lessons. Each title appears once for each kind.
/// Builds every scene, so this may take some time; stops early when `goesOn` returns false.
std::vector<KnownEffect> effectsKnownBy(const LessonLibrary &library, const std::function<bool()> &goesOn);

}
