#include "sim/effects/drivers/steering.h"

namespace sim {

std::vector<Region> Steering::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/steering.h", "steer_by_keys"},
            {"sim/effects/drivers/steering.h", "steer_by_pointer"}};
}

void Steering::drive(State &state, double h) const
{
    const InputState &input = state.input;
    double &speed = state.gaitSpeed[m_clock];
    if (input.pointer && input.pointerDown)
        speed = steerByPointer(input.pointer->x - state.positionOf(m_body).x, m_limits);
    else if (input.keys.right || input.keys.left)
        speed = steerByKeys(speed, input.keys, m_limits, h);
}

std::vector<LiveValue> Steering::explain(const State &before, const State &after, int) const
{
    return {{"speed", after.gaitSpeed[m_clock], before.gaitSpeed[m_clock]}};
}

namespace descriptions {
constinit const EffectDescription steering = {
    "steering", SIM_TEXT("steering"), EffectKind::driver,
    SIM_TEXT("Lets the arrow keys and the pointer set how fast the legs swing.")};
}

}
