#pragma once

#include "app/ui/time/timeline_painter.h"

namespace app {

class ComparisonRuns;

/// Returns what the timeline shows of a run and its branches.
RunView runViewOf(const sim::Timeline &timeline, const ComparisonRuns &comparisons, bool isPlaying);

/// Updates `view` after only the cursor has moved.
void follow(RunView &view, const sim::Timeline &timeline);

}
