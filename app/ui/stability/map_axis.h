#pragma once

#include "sim/analysis/stability/growth_map.h"

#include <algorithm>
#include <cmath>

namespace app {

// How a map of growth is put onto linear axes and into colours.

constexpr double mostShown = 10.0; ///< growth a frame: faster has the last colour
constexpr double holding = -0.05; ///< a cell's value where nothing grows; others have the logarithm of growth

/// Where a value is on its axis: colour maps have cells of one size, so that what goes by ratio has its logarithm.
inline double onAxis(const sim::MapAxis &axis, double value)
{
    return axis.parameter == "damp" ? value : std::log10(std::max(value, axis.values.front()));
}

/// From one of the axis' values to the next.
inline double spacing(const sim::MapAxis &axis)
{
    return (onAxis(axis, axis.values.back()) - onAxis(axis, axis.values.front())) /
           static_cast<double>(axis.values.size() - 1);
}

}
