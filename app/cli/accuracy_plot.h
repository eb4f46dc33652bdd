#pragma once

#include "app/cli/accuracy_report.h"

#include <QByteArray>

namespace app {

/// Error against time of everything that was measured, as an SVG picture: both logarithmic, a ladder a method.
QByteArray accuracyPlot(const AccuracyReport &report);

}
