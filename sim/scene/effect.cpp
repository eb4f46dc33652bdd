#include "sim/scene/effect.h"

namespace sim {

std::vector<LiveValue> motionChange(const State &before, const State &after, int point)
{
    std::vector<LiveValue> live;
    if (before.positionOf(point) != after.positionOf(point))
        live.push_back({"x", after.positionOf(point), before.positionOf(point)});
    if (before.velocityOf(point) != after.velocityOf(point))
        live.push_back({"v", after.velocityOf(point), before.velocityOf(point)});
    return live;
}

}
