#pragma once

#include "sim/analysis/accuracy/study_monitor.h"

namespace sim {

/// Times all measured rows by interleaved runs, and notes the noise.
void measureTimes(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor);

}
