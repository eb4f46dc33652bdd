#include "sim/effects/drivers/gait_clock.h"

namespace sim {

std::vector<Region> GaitClock::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/gait_clock.h", "gait_clock"}};
}

int GaitClock::count(const State &state, PointRange) const
{
    return static_cast<int>(state.gait.rows());
}

void GaitClock::drive(State &state, double h) const
{
    for (Eigen::Index i = 0; i < state.gait.rows(); ++i)
        state.gait[i] = tick(state.gait[i], state.gaitSpeed[i], h);
}

std::vector<LiveValue> GaitClock::explain(const State &before, const State &after, int point) const
{
    const int clock = m_clockOf.empty() ? 0 : m_clockOf.at(static_cast<std::size_t>(point));
    return {{"speed", before.gaitSpeed[clock]}, {"gait", after.gait[clock], before.gait[clock]}};
}

namespace descriptions {
constinit const EffectDescription gait_clock = {
    "gait_clock", SIM_TEXT("gait clock"), EffectKind::driver,
    SIM_TEXT("Advances the angle of the legs a little in each frame: the rhythm of the walk.")};
}

}
