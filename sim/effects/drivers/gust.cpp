#include "sim/effects/drivers/gust.h"

namespace sim {

std::vector<Region> GustFront::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/gust.h", "gust"}};
}

int GustFront::count(const State &, PointRange points) const
{
    return points.count;
}

void GustFront::drive(State &state, double h) const
{
    state.gustExtent = advanceGust(state.gustExtent, state.input.pointerDown, m_speed, h);
}

std::vector<LiveValue> GustFront::explain(const State &before, const State &after, int) const
{
    return {{"front", after.gustExtent.front, before.gustExtent.front},
            {"tail", after.gustExtent.tail, before.gustExtent.tail}};
}

namespace descriptions {
constinit const EffectDescription gust = {
    "gust", SIM_TEXT("gust runs on"), EffectKind::wind,
    SIM_TEXT("Lets a gust run outwards from the pointer, so that near branches feel it first.")};
}

}
