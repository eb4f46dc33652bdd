#include "sim/analysis/energy/energy_accounting.h"

#include "sim/pipeline/method.h"
#include "sim/run/script/composed_interval.h"
#include "sim/simd/flush_denormals.h"

#include <optional>

namespace sim {

namespace {

/// To whom what a phase changes belongs; nothing for what forces and motion do, which takes more than a look at both
/// sides of it.
std::optional<Account> accountOf(const Phase &phase)
{
    const Effect *effect = phase.effect.get();
    if (as<Drag>(phase.effect))
        return Account::damping;
    if (as<Contact>(phase.effect))
        return Account::impact;
    if (as<Constraint>(phase.effect))
        return effect->kind() == EffectKind::contact ? Account::impact : Account::sticks;
    if (const auto *driver = as<Driver>(phase.effect)) {
        if (driver->timing() == DriverTiming::dependent)
            return Account::hand; // it only stops what is held
        return effect->kind() == EffectKind::wind ? Account::wind : Account::motors;
    }
    if (!effect && !phase.consumesAcceleration && phase.kickFrames == 0.0)
        return Account::sticks; // the velocities that belong to where they put things
    return {};
}

bool isForce(const Phase &phase)
{
    return as<Force>(phase.effect) || as<Torque>(phase.effect);
}

/// A driver that moves nothing.
bool isClock(const Phase &phase)
{
    const auto *driver = as<Driver>(phase.effect);
    return driver && driver->timing() == DriverTiming::continuous;
}

}

EnergyAccounting::EnergyAccounting(const ComposedInterval &interval, DirectionRule directionRule)
    : m_interval(interval), m_directionRule(directionRule), m_reader(interval.scene),
      m_integrals(interval.scene, m_reader, directionRule)
{
}

void EnergyAccounting::row(State &state, Balance &into) const
{
    const FlushDenormals flush;
    for (int i = 0; i < m_interval.pipeline.step.stepsPerOutput; ++i)
        step(state, into);
}

void EnergyAccounting::step(State &state, Balance &into) const
{
    const std::vector<Phase> &phases = m_interval.pipeline.phases;
    std::size_t last = 0;
    for (std::size_t i = 0; i < phases.size(); ++i)
        last = phases[i].integrates ? i : last;
    const State start = state;
    Open open;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        if (phases[i].integrates) {
            wholeStep(state, i, last, into);
            i = last;
        } else {
            onePhase(phases[i], state, open, into);
        }
    }
    for (const Tick &tick : open.ticks)
        clock(tick, start, state, into);
}

void EnergyAccounting::wholeStep(State &state, std::size_t first, std::size_t last, Balance &into) const
{
    const std::vector<Phase> &phases = m_interval.pipeline.phases;
    const State before = state;
    if (const auto &byLaps = phases[first].runBySegments) {
        PowerIntegrals::Begun begun(before);
        byLaps(state, [&](const DenseSegment &segment) { m_integrals.addSegment(begun, segment, into); });
        return;
    }
    for (std::size_t i = first; i <= last; ++i)
        phases[i].run(state);
    m_integrals.step(before, state, m_interval.pipeline.step.h, into);
}

void EnergyAccounting::onePhase(const Phase &phase, State &state, Open &open, Balance &into) const
{
    const State before = state;
    phase.run(state);
    if (isForce(phase))
        gather(phase, before, state, open.gathering, into);
    else if (phase.kickFrames > 0.0)
        kick(phase, before, state, open.gathering, into);
    else if (isClock(phase))
        open.ticks.push_back({before, state});
    else if (const std::optional<Account> account = accountOf(phase))
        change(*account, before, state, into);
}

void EnergyAccounting::clock(const Tick &tick, const State &start, const State &end, Balance &into) const
{
    for (const State *moment : {&start, &end}) {
        State before = tick.before, after = tick.after;
        before.position = after.position = moment->position;
        before.angle = after.angle = moment->angle;
        into.energy[Account::motors] += 0.5 * (m_reader.stored(after) - m_reader.stored(before));
    }
}

void EnergyAccounting::change(Account account, const State &before, const State &after, Balance &into) const
{
    const StoredEnergy was = m_reader.read(before), is = m_reader.read(after);
    into.energy[account] += is.total() - was.total();
    into.momentum[account] = into.momentum[account] + is.momentum - was.momentum;
}

/// A force acts on velocities at once, or it is gathered for a kick to come.
void EnergyAccounting::gather(const Phase &phase, const State &before, const State &after,
                              Gathering &gathering, Balance &into) const
{
    const auto *force = as<Force>(phase.effect);
    const auto *torque = as<Torque>(phase.effect);
    Gathered one{phase.effect,
                 Eigen::ArrayX2d::Zero(before.pointCount(), 2),
                 Eigen::ArrayXd::Zero(before.pointCount()),
                 {}};
    const bool balances = m_reader.conservesMomentum(*phase.effect);
    if (force && balances)
        one.heldPush = heldPush(*force, before, phase.points, m_reader, m_directionRule);
    const Account account = accountOf(*phase.effect, m_reader);
    if (force && after.acceleration.rows() == 0) {
        Vec2 &push = into.momentum[balances ? Account::hand : account];
        push = push + (balances ? m_interval.pipeline.step.h * one.heldPush
                                : m_reader.momentum(after) - m_reader.momentum(before));
    }
    if (!m_reader.isStored(*phase.effect))
        into.energy[account] += m_reader.moving(after) - m_reader.moving(before);
    if (force)
        force->add(before, phase.points, 1.0, m_directionRule, one.pull);
    else
        torque->add(before, phase.points, 1.0, one.turn);
    if (gathering.isSpent)
        gathering = {};
    gathering.forces.push_back(std::move(one));
}

void EnergyAccounting::kick(const Phase &phase, const State &before, const State &after, Gathering &gathering,
                            Balance &into) const
{
    gathering.isSpent = true;
    for (const Gathered &one : gathering.forces) {
        const Account account = sim::accountOf(*one.effect, m_reader);
        const bool stored = m_reader.isStored(*one.effect);
        if (m_reader.turns()) {
            const Eigen::ArrayXd work = m_reader.mass() * one.turn * 0.5 * (before.spin + after.spin);
            into.energy[account] += stored ? 0.0 : phase.kickFrames * work.sum();
            continue;
        }
        const Eigen::ArrayX2d push = one.pull.colwise() * m_reader.mass();
        const Vec2 sum = {push.col(0).sum(), push.col(1).sum()};
        const bool balances = m_reader.conservesMomentum(*one.effect);
        Vec2 &given = into.momentum[balances ? Account::hand : account];
        given = given + phase.kickFrames * (balances ? one.heldPush : sum);
        if (!stored)
            into.energy[account] +=
                phase.kickFrames * 0.5 * (push * (before.velocity + after.velocity)).sum();
    }
}

}
