#pragma once

#include "app/model/document.h"

#include <cstdint>
#include <map>
#include <optional>

namespace app {

/// What the window is arranged for.
enum class WindowMode { learn, measure, build };

/// What a window that closes to open again leaves to the next one, besides the settings and the session, which stays.
struct Left
{
    std::map<StepName, Document::Saved> saved; ///< what the files of its steps have
    WindowMode mode = WindowMode::learn;
    std::optional<std::int64_t> goal; ///< the frame that the run is on its way to
    bool isPlaying = false;
    bool isSceneOnly = false; ///< without panels
};

}
