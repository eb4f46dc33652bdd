#pragma once

#include "sim/analysis/accuracy/study.h"

#include <QByteArray>

#include <vector>

namespace app {

// A study of accuracy as comma-separated text. Empty where there is nothing measured.

/// Each row that was measured: its method, step or tolerance, error, forces, times, and whether it is on the front.
QByteArray accuracyRows(const sim::Accuracy &accuracy);
/// How far off some of its rows are at each frame: a column each.
QByteArray errorsOverRun(const sim::Accuracy &accuracy, const std::vector<std::size_t> &rows);

}
