#pragma once

#include "lessons/api/parameter.h"

#include <vector>

/// The parameters of this lesson, grouped as the steps introduce them.
namespace codeling {

/// Returns `k`, `keep`, `dt`, and `target_x` and `target_y` of the first target.
std::vector<lessons::Parameter> motorParameters();
lessons::Parameter restLength();
lessons::Parameter anticipationPart();
/// Returns `soft`, `hard`, `along`, `across`, `min_length` and `max_length`.
std::vector<lessons::Parameter> spineParameters();
/// Returns `tentacles`, `links` and `water`.
std::vector<lessons::Parameter> tentacleParameters();

}
