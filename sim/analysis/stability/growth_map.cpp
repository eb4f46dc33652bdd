#include "sim/analysis/stability/growth_map.h"

#include <cmath>

namespace sim {

MapAxis MapAxis::evenly(std::string parameter, double low, double high, int count)
{
    MapAxis axis{std::move(parameter), {}};
    for (int i = 0; i < count; ++i)
        axis.values.push_back(low + (high - low) * i / (count - 1));
    return axis;
}

MapAxis MapAxis::byRatio(std::string parameter, double low, double high, int count)
{
    MapAxis axis{std::move(parameter), {}};
    for (int i = 0; i < count; ++i)
        axis.values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return axis;
}

GrowthMap growthMap(const Script &script, const Values &values, const State &state, MapAxis x, MapAxis y,
                    const MapProgress &progress)
{
    GrowthMap map{std::move(x), std::move(y), {}};
    Values changed = values;
    double h = script.step.h;
    const auto set = [&](const MapAxis &axis, double value) {
        if (axis.parameter.empty())
            h = value;
        else
            changed.set(axis.parameter, value);
    };
    for (const double row : map.y.values) {
        set(map.y, row);
        for (const double column : map.x.values) {
            set(map.x, column);
            map.growth.push_back(growthOf(sceneOf(script, changed), state, *script.method, h));
        }
        if (!progress(map))
            break;
    }
    return map;
}

}
