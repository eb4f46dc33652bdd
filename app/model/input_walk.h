#pragma once

#include "sim/base/error.h"
#include "sim/run/script/script.h"

#include <functional>
#include <string>
#include <vector>

namespace app {

/// What an event of an input does where it stands.
enum class EventEffect {
    works,
    noSuchBody,  ///< takes hold of a body that is not there at that time
    onlyLetsGo,  ///< the same, but lets go of the one held before
    nothingHeld, ///< moves or lets go of nothing
};

/// A scene that cannot be built.
struct SceneRefused : sim::Error
{
    SceneRefused(const sim::Error &error, int index) : sim::Error(error), event(index) {}
    int event; ///< the event after which, or -1: at the start
};

/// Walks through the input of a run in the order in which the run applies it: by rows, a row's parameters first.
/// `input` must be sorted. Calls `newScene(scene, index)` for the start (index -1) and whenever parameters change
/// (index: the event that does), and `each(index, effect)` for every event.
/// @throws SceneRefused
void walkInput(const sim::Script &script, const std::vector<sim::Event> &input,
               const std::function<void(const sim::Scene &, int)> &newScene,
               const std::function<void(int, EventEffect)> &each);

}
