#pragma once

#include "sim/analysis/accuracy/study_monitor.h"

namespace sim {

/// Times all measured rows of `found` by interleaved runs, and sets its noise.
void measureTimes(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor);

}
