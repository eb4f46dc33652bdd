#pragma once

#include "sim/analysis/accuracy/study_run.h"

namespace sim {

/// px: a row whose bodies are farther off than this is unstable.
constexpr double unstableFrom = 1e6;

/// Every rung of every method, waiting, with the way in use among them.
std::vector<AccuracyRow> waitingRows(const StudyPlan &plan);

/// Measures the errors of all rows up to the horizon of `found`.
void measureErrors(const Script &script, const StudyPlan &plan, Accuracy &found, StudyMonitor &monitor);

}
