#pragma once

#include "app/ui/time/timeline_painter.h"

namespace app {

class Session;

/// Returns what the timeline shows of the session's run.
RunView runViewOf(const Session &session);

/// Updates `view` after only the cursor has moved.
void follow(RunView &view, const Session &session);

}
