#pragma once

#include "tests/bench/results.h"

#include <string>

namespace bench {

/// Returns the race of creature_in_air.h as an SVG file: microseconds per frame of each team at each error,
/// with the ratios to ours. Empty unless we and at least one other team were measured at every error.
std::string raceFigure(const Measurements &medians);

}
