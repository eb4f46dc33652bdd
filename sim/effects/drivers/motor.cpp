#include "sim/effects/drivers/motor.h"

#include "sim/effects/pairs/pair_jacobian.h"
namespace sim {

std::vector<Region> Motor::regions(Directions) const
{
    return {{"sim/effects/drivers/motor.h", "motor"}, {"sim/effects/pairs/spring.h", "spring"}};
}

int Motor::count(const State &state, Points points) const
{
    return points.contains(m_mover) && state.feels(m_mover) ? 1 : 0;
}

void Motor::add(const State &state, Points movers, double scale, Directions, Eigen::ArrayX2d &into) const
{
    if (count(state, movers) == 0)
        return;
    const Vec2 pull = motor(state.at(m_mover), state.outside.target, m_k, m_dt).pull;
    into(m_mover, 0) += scale * state.inverseMass[m_mover] * pull.x;
    into(m_mover, 1) += scale * state.inverseMass[m_mover] * pull.y;
}

bool Motor::addSlopes(const State &state, Points movers, double scale, Directions, Slopes &into) const
{
    if (count(state, movers) > 0)
        addSlope(into, m_mover, m_mover,
                 (scale * state.inverseMass[m_mover]) * slopeToPlace(m_k * m_dt * m_dt));
    return true;
}

std::vector<Live> Motor::explain(const State &state, int mover, Directions) const
{
    if (count(state, {mover, 1}) == 0)
        return {};
    const SpringPull s = motor(state.at(mover), state.outside.target, m_k, m_dt);
    return {{"d", s.d}, {"pull", state.inverseMass[mover] * s.pull}};
}

std::vector<Region> Anticipation::regions(Directions) const
{
    return {{"sim/effects/drivers/motor.h", "anticipation"}};
}

int Anticipation::count(const State &state, Points points) const
{
    return points.contains(m_mover) && state.feels(m_mover) ? 1 : 0;
}

void Anticipation::drive(State &state, double) const
{
    for (const Vec2 target : state.outside.newTargets) {
        if (!state.feels(m_mover))
            break;
        const Shifted to = anticipate(state.at(m_mover), state.speed(m_mover), target, m_anticipation);
        state.place(m_mover, to.x);
        state.push(m_mover, to.v);
    }
    state.outside.newTargets.clear();
}

std::vector<Live> Anticipation::explain(const State &before, const State &after, int point) const
{
    if (point != m_mover || before.at(point) == after.at(point))
        return {};
    return {{"shift", after.at(point) - before.at(point)},
            {"x", after.at(point), before.at(point)},
            {"v", after.speed(point), before.speed(point)}};
}

namespace described {
constinit const Description motor = {"motor", SIM_TEXT("motor"), Kind::spring,
                                     SIM_TEXT("Pulls the swimmer to its target, as a spring does.")};
}

namespace described {
constinit const Description anticipation = {
    "anticipation", SIM_TEXT("anticipation"), Kind::driver,
    SIM_TEXT("Shifts the swimmer back before it goes to a new target, as a cat draws back before it leaps.")};
}

}
