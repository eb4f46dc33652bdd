#pragma once

#include "sim/analysis/stability/growth_map.h"

#include <QByteArray>

namespace app {

/// A map of growth as comma-separated text: a row each place of the map, as far as it is computed. A growth above 1 means
/// that disturbances grow. Empty where nothing is computed.
QByteArray growthTable(const sim::GrowthMap &map);

}
