#pragma once

#include "app/ui/time/timeline_painter.h"

namespace app {

class Session;

/// What the timeline shows of the session's run.
RunView runViewOf(const Session &session);

/// Brings `view` to where the cursor is now, when nothing else has changed.
void follow(RunView &view, const Session &session);

}
