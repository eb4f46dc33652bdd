#pragma once

#include "sim/analysis/accuracy/study.h"

#include <QByteArray>

#include <vector>

namespace app {

// Exports an accuracy study as comma-separated text. Empty if nothing was measured.

/// Returns a row for each measurement: method, step or tolerance, error, forces, times, and whether it is on the Pareto
/// front.
QByteArray accuracyRows(const sim::Accuracy &accuracy);
/// Returns the errors of some rows at each frame, with one column per row.
QByteArray errorsOverRun(const sim::Accuracy &accuracy, const std::vector<std::size_t> &rows);

}
