#pragma once

#include "sim/base/error.h"
#include "sim/run/script/script.h"

#include <functional>
#include <vector>

namespace app {

/// The effect of an input event at its place in the run.
enum class EventEffect {
    works,
    noSuchBody,  ///< grabs a body that does not exist at that time
    onlyLetsGo,  ///< the same, but releases the body held before
    nothingHeld, ///< moves or releases while no body is held
};

/// The error of a scene that cannot be built.
struct SceneRefused : sim::Error
{
    SceneRefused(const sim::Error &error, int index) : sim::Error(error), event(index) {}
    int event; ///< the event that led to the scene, or -1 for the start
};

/// Walks through a run's input in the order in which the run applies it: by output steps, with an output step's
/// parameters first. `input` must be sorted by frame. Calls `newScene(scene, index)` for the start (index -1) and
/// after each change of parameters (index of the event). Calls `each(index, effect)` for every event.
/// @throws SceneRefused: a scene cannot be built
void walkInput(const sim::Script &script, const std::vector<sim::Event> &input,
               const std::function<void(const sim::Scene &, int)> &newScene,
               const std::function<void(int, EventEffect)> &each);

}
