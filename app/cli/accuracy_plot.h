#pragma once

#include "app/cli/accuracy_report.h"
#include "app/model/experiment/experiment.h"

#include <QIODevice>

namespace app {

/// Writes the window's plot of error against time, with all methods, as an SVG file. Needs a QApplication. Returns whether
/// this worked.
bool writeAccuracyPlot(QIODevice &file, const AccuracyReport &report, const Experiment &experiment,
                       const LessonLibrary &library);

}
