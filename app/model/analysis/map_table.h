#pragma once

#include "sim/analysis/settling/settling.h"
#include "sim/analysis/stability/growth_map.h"

#include <QByteArray>

namespace app {

// Maps as comma-separated text, with one row per computed place of the map. Empty if nothing was computed.

/// Returns a map of growth. A growth above 1 means that disturbances grow.
QByteArray growthTable(const sim::GrowthMap &map);
/// Returns a map of settling times. Where the run does not settle, the frames are empty, and the last column says why.
QByteArray settlingTable(const sim::SettlingMap &map);

}
