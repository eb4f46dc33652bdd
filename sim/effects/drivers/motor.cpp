#include "sim/effects/drivers/motor.h"

#include "sim/effects/pairs/pair_jacobian.h"

namespace sim {

std::vector<Region> Motor::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/motor.h", "motor"}, {"sim/effects/pairs/spring.h", "spring"}};
}

int Motor::count(const State &state, PointRange points) const
{
    return points.contains(m_mover) && state.isDynamic(m_mover) ? 1 : 0;
}

void Motor::add(const State &state, PointRange movers, double scale, DirectionRule,
                Eigen::ArrayX2d &into) const
{
    if (count(state, movers) == 0)
        return;
    const Vec2 pull = motor(state.positionOf(m_mover), state.input.target, m_k, m_dt).pull;
    into(m_mover, 0) += scale * state.inverseMass[m_mover] * pull.x;
    into(m_mover, 1) += scale * state.inverseMass[m_mover] * pull.y;
}

bool Motor::addJacobian(const State &state, PointRange movers, double scale, DirectionRule,
                        Jacobian &jacobian) const
{
    if (count(state, movers) > 0)
        addJacobianBlock(jacobian, m_mover, m_mover,
                         (scale * state.inverseMass[m_mover]) * pointSpringJacobian(m_k * m_dt * m_dt));
    return true;
}

std::vector<LiveValue> Motor::explain(const State &state, int mover, DirectionRule) const
{
    if (count(state, {mover, 1}) == 0)
        return {};
    const SpringPull spring = motor(state.positionOf(mover), state.input.target, m_k, m_dt);
    return {{"d", spring.d}, {"pull", state.inverseMass[mover] * spring.pull}};
}

std::vector<Region> Anticipation::regions(DirectionRule) const
{
    return {{"sim/effects/drivers/motor.h", "anticipation"}};
}

int Anticipation::count(const State &state, PointRange points) const
{
    return points.contains(m_mover) && state.isDynamic(m_mover) ? 1 : 0;
}

void Anticipation::drive(State &state, double) const
{
    for (const Vec2 target : state.input.newTargets) {
        if (!state.isDynamic(m_mover))
            break;
        const Shifted shifted =
            anticipate(state.positionOf(m_mover), state.velocityOf(m_mover), target, m_anticipation);
        state.place(m_mover, shifted.x);
        state.setVelocity(m_mover, shifted.v);
    }
    state.input.newTargets.clear();
}

std::vector<LiveValue> Anticipation::explain(const State &before, const State &after, int point) const
{
    if (point != m_mover || before.positionOf(point) == after.positionOf(point))
        return {};
    return {{"shift", after.positionOf(point) - before.positionOf(point)},
            {"x", after.positionOf(point), before.positionOf(point)},
            {"v", after.velocityOf(point), before.velocityOf(point)}};
}

namespace descriptions {
constinit const EffectDescription motor = {"motor", SIM_TEXT("motor"), EffectKind::spring,
                                           SIM_TEXT("Pulls the swimmer to its target, like a spring.")};
constinit const EffectDescription anticipation = {
    "anticipation", SIM_TEXT("anticipation"), EffectKind::driver,
    SIM_TEXT("Moves the swimmer back a little before it starts towards a new target, like a cat before it "
             "jumps.")};
}

}
