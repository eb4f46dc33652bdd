#pragma once

#include "sim/analysis/stability/stability.h"
#include "sim/run/script/script.h"

#include <functional>
#include <string>
#include <vector>

namespace sim {

/// What one side of a map changes, and through which values.
struct MapAxis
{
    std::string parameter;      ///< a parameter of the scene; empty: the step, in frames
    std::vector<double> values; ///< from left to right, or from the bottom up

    /// `count` values from `low` to `high`, evenly by difference.
    static MapAxis evenly(std::string parameter, double low, double high, int count);
    /// The same evenly by ratio; both above 0.
    static MapAxis byRatio(std::string parameter, double low, double high, int count);
};

/// How fast disturbances grow over a plane of two numbers, all else staying as it is.
struct GrowthMap
{
    MapAxis x;
    MapAxis y;
    std::vector<double> growth; ///< a frame, beyond the motion itself; row after row of y, as far as computed

    /// Where both are known.
    double at(std::size_t column, std::size_t row) const { return growth[row * x.values.size() + column]; }
};

/// Told after each row; returns false to stop.
using MapProgress = std::function<bool(const GrowthMap &soFar)>;

/// Computes growthOf() for each pair of values: the scene is built anew, at the same places.
/// @throws Error when a scene cannot be built or computed
GrowthMap growthMap(const Script &script, const Values &values, const State &state, MapAxis x, MapAxis y,
                    const MapProgress &progress);

}
