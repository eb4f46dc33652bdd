#pragma once

#include "sim/analysis/stability/growth_map.h"

#include <QByteArray>

namespace app {

/// Returns a growth map as comma-separated text, with one row per computed place of the map. A growth above 1 means
/// that disturbances grow. Empty if nothing was computed.
QByteArray growthTable(const sim::GrowthMap &map);

}
