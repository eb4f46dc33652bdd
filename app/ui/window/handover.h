#pragma once

#include "app/model/files/document.h"
#include "app/model/session/session.h"
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

/// Stops all that moves in `session`, so that no time passes between two windows. Returns what the next window needs.
Handover handOver(Session &session, const Document &document, WindowMode mode, bool isSceneOnly);

/// Lets `session` and its files go on as `from` says: with the same saved state, goal and playback.
void takeOver(const Handover &from, Session &session, Document &document);

}
