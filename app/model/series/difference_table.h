#pragma once

#include "app/model/series/difference_series.h"

#include <QByteArray>

namespace app {

/// Returns the differences of two runs as comma-separated text, with one row per sampled frame: the distance and its
/// body. Empty if there is no comparison.
QByteArray differenceTable(const DifferenceSeries &series);

}
