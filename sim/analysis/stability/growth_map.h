#pragma once

#include "sim/analysis/stability/stability.h"
#include "sim/run/script/script.h"

#include <functional>
#include <string>
#include <vector>

namespace sim {

/// One axis of a map: the number that it changes, and its values.
struct MapAxis
{
    std::string parameter;      ///< a parameter of the scene; empty: the step, in frames
    std::vector<double> values; ///< from left to right, or from bottom to top

    /// Returns an axis of `count` equally spaced values from `low` to `high`.
    static MapAxis evenly(std::string parameter, double low, double high, int count);
    /// Returns an axis of `count` values from `low` to `high` with equal ratios. Both must be above 0.
    static MapAxis byRatio(std::string parameter, double low, double high, int count);
};

/// The growth of disturbances over a plane of two numbers, with everything else unchanged.
struct GrowthMap
{
    MapAxis x;
    MapAxis y;
    std::vector<double> growth; ///< factor per frame, see growthOf(); by rows of y, as far as computed

    /// Returns the growth at a column and row that have been computed.
    double at(std::size_t column, std::size_t row) const { return growth[row * x.values.size() + column]; }
};

/// Called after each row. Returns false to stop.
using MapProgress = std::function<bool(const GrowthMap &soFar)>;

/// Computes growthOf() for each pair of values. Each pair composes a new scene, at the positions of `state`.
/// @throws Error when a scene cannot be composed or computed
GrowthMap growthMap(const Script &script, const Values &values, const State &state, MapAxis x, MapAxis y,
                    const MapProgress &progress);

}
