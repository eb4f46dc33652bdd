#pragma once

#include "app/model/files/document.h"
#include "app/ui/dock/window_mode.h"

#include <cstdint>
#include <map>
#include <optional>

namespace app {

/// What a window that opens again hands over to the next one, besides the settings and the session, which stays.
struct Handover
{
    std::map<StepName, Document::Saved> saved; ///< the saved state of its files
    WindowMode mode = WindowMode::learn;
    std::optional<std::int64_t> goal; ///< the frame that the session is going to
    bool isPlaying = false;
    bool isSceneOnly = false; ///< without panels
};

}
