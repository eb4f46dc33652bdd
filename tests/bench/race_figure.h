#pragma once

#include "results.h"

#include <string>

namespace bench {

/// The race of creature_in_air.h as an SVG file: microseconds a frame of each team at each error, with the ratios to
/// ours. Empty where ours was not measured at every error, or nobody else was at any.
std::string raceFigure(const Measurements &medians);

}
