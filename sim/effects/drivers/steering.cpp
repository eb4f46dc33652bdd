#include "sim/effects/drivers/steering.h"

namespace sim {

std::vector<Region> Steering::regions(Directions) const
{
    return {{"sim/effects/drivers/steering.h", "steer_by_keys"},
            {"sim/effects/drivers/steering.h", "steer_by_pointer"}};
}

void Steering::drive(State &state, double h) const
{
    const Outside &outside = state.outside;
    double &speed = state.gaitSpeed[m_clock];
    if (outside.pointer && outside.pointerDown)
        speed = steerByPointer(outside.pointer->x - state.at(m_body).x, m_reins);
    else if (outside.keys.right || outside.keys.left)
        speed = steerByKeys(speed, outside.keys, m_reins, h);
}

std::vector<Live> Steering::explain(const State &before, const State &after, int) const
{
    return {{"speed", after.gaitSpeed[m_clock], before.gaitSpeed[m_clock]}};
}

namespace described {
constinit const Description steering = {
    "steering", SIM_TEXT("steering"), Kind::driver,
    SIM_TEXT("Lets the arrow keys and the pointer set how fast the legs swing.")};
}

}
