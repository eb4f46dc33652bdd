#include "sim/effects/drivers/gust.h"

namespace sim {

std::vector<Region> GustFront::regions(Directions) const
{
    return {{"sim/effects/drivers/gust.h", "gust"}};
}

int GustFront::count(const State &, Points points) const
{
    return points.count;
}

void GustFront::drive(State &state, double h) const
{
    state.gale = runOn(state.gale, state.outside.pointerDown, m_speed, h);
}

std::vector<Live> GustFront::explain(const State &before, const State &after, int) const
{
    return {{"front", after.gale.front, before.gale.front}, {"end", after.gale.end, before.gale.end}};
}

namespace described {
constinit const Description gust = {
    "gust", SIM_TEXT("gust runs on"), Kind::wind,
    SIM_TEXT("Lets a gust run outwards from the pointer, so that near branches feel it first.")};
}

}
