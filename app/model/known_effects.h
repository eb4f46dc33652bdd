#pragma once

#include "app/model/lesson_library.h"
#include "sim/scene/effect.h"

#include <functional>

namespace app {

/// An effect that some lesson's scene lists.
struct KnownEffect
{
    std::string id;
    std::string title; ///< in English; see SIM_TEXT
    std::string purpose;
    sim::EffectKind kind = sim::EffectKind::motion;
    QString lesson; ///< the title of the first one that lists it
};

/// What the scenes of all steps list, each title once for each kind, in the order of the lessons. Sets up every scene,
/// so that it may take some time; leaves off when `goesOn` says no.
std::vector<KnownEffect> effectsKnownBy(const LessonLibrary &library, const std::function<bool()> &goesOn);

}
