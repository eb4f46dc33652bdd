#pragma once

#include "lessons/api/step.h"
#include "sim/run/track.h"

#include <string>

namespace app {

/// Returns the first line of a trace: the names of its columns.
const char *traceTitles(lessons::TraceColumns columns);
/// Appends a line for each body at the cursor of `track`. Each number has the fewest digits that give the same number when
/// read back.
void appendTraceRow(std::string &text, const sim::Track &track, lessons::TraceColumns columns);

}
