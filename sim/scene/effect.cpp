#include "sim/scene/effect.h"

namespace sim {

std::vector<Live> changeOf(const State &before, const State &after, int point)
{
    std::vector<Live> live;
    if (before.at(point) != after.at(point))
        live.push_back({"x", after.at(point), before.at(point)});
    if (before.speed(point) != after.speed(point))
        live.push_back({"v", after.speed(point), before.speed(point)});
    return live;
}

}
