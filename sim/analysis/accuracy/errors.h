#pragma once

#include "sim/analysis/accuracy/study_run.h"

namespace sim {

/// px. A run is unstable when a point is farther than this from the reference.
constexpr double divergenceDistance = 1e6;

/// Returns one waiting row per refinement level of each method. A row for `plan.inUse` is added if no level
/// equals it.
std::vector<AccuracyRow> waitingRows(const StudyPlan &plan);

/// Measures the errors of all rows of `found` up to its horizon and writes them into the rows.
void measureErrors(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor);

}
