#include "sim/analysis/energy/energy_accounting.h"

#include "sim/pipeline/method.h"
#include "sim/run/script/composed_interval.h"
#include "sim/simd/flush_denormals.h"

#include <optional>

namespace sim {

namespace {

/// Returns the account of the change by a phase. Returns nothing for forces and motion, which need more than
/// the states before and after.
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
            return Account::hand; // it only stops the held point
        return effect->kind() == EffectKind::wind ? Account::wind : Account::motors;
    }
    if (!effect && !phase.consumesAcceleration && phase.kickFrames == 0.0)
        return Account::sticks; // the velocity update from corrected positions
    return {};
}

bool isForce(const Phase &phase)
{
    return as<Force>(phase.effect) || as<Torque>(phase.effect);
}

/// Returns whether a phase is a driver that advances a clock and moves no point.
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

void EnergyAccounting::outputStep(State &state, Balance &balance) const
{
    const FlushDenormals flush;
    for (int i = 0; i < m_interval.pipeline.step.stepsPerOutput; ++i)
        step(state, balance);
}

void EnergyAccounting::step(State &state, Balance &balance) const
{
    const std::vector<Phase> &phases = m_interval.pipeline.phases;
    std::size_t last = 0;
    for (std::size_t i = 0; i < phases.size(); ++i)
        last = phases[i].integrates ? i : last;
    const State start = state;
    OpenStep openStep;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        if (phases[i].integrates) {
            runWholeStep(state, i, last, balance);
            i = last;
        } else {
            runPhase(phases[i], state, openStep, balance);
        }
    }
    for (const ClockAdvance &advance : openStep.clocks)
        addClock(advance, start, state, balance);
}

void EnergyAccounting::runWholeStep(State &state, std::size_t first, std::size_t last, Balance &balance) const
{
    const std::vector<Phase> &phases = m_interval.pipeline.phases;
    const State before = state;
    if (const auto &runWithDenseOutput = phases[first].runWithDenseOutput) {
        PowerIntegrals::PhaseStart start(before);
        runWithDenseOutput(
            state, [&](const DenseSegment &segment) { m_integrals.addSegment(start, segment, balance); });
        return;
    }
    for (std::size_t i = first; i <= last; ++i)
        phases[i].run(state);
    m_integrals.step(before, state, m_interval.pipeline.step.h, balance);
}

void EnergyAccounting::runPhase(const Phase &phase, State &state, OpenStep &openStep, Balance &balance) const
{
    const State before = state;
    phase.run(state);
    if (isForce(phase))
        addForce(phase, before, state, openStep.pending, balance);
    else if (phase.kickFrames > 0.0)
        addKick(phase, before, state, openStep.pending, balance);
    else if (isClock(phase))
        openStep.clocks.push_back({before, state});
    else if (const std::optional<Account> account = accountOf(phase))
        addChange(*account, before, state, balance);
}

void EnergyAccounting::addClock(const ClockAdvance &advance, const State &start, const State &end,
                                Balance &balance) const
{
    for (const State *moment : {&start, &end}) {
        State before = advance.before, after = advance.after;
        before.position = after.position = moment->position;
        before.angle = after.angle = moment->angle;
        balance.energy[Account::motors] += 0.5 * (m_reader.stored(after) - m_reader.stored(before));
    }
}

void EnergyAccounting::addChange(Account account, const State &before, const State &after,
                                 Balance &balance) const
{
    const StoredEnergy storedBefore = m_reader.read(before), storedAfter = m_reader.read(after);
    balance.energy[account] += storedAfter.total() - storedBefore.total();
    balance.momentum[account] = balance.momentum[account] + storedAfter.momentum - storedBefore.momentum;
}

/// Accounts for a force that acts on velocities at once, or keeps it for the next kick.
void EnergyAccounting::addForce(const Phase &phase, const State &before, const State &after,
                                PendingForces &pending, Balance &balance) const
{
    const auto *force = as<Force>(phase.effect);
    const auto *torque = as<Torque>(phase.effect);
    PendingForce entry{phase.effect,
                       Eigen::ArrayX2d::Zero(before.pointCount(), 2),
                       Eigen::ArrayXd::Zero(before.pointCount()),
                       {}};
    const bool conserves = m_reader.conservesMomentum(*phase.effect);
    if (force && conserves)
        entry.holdingForce = holdingForce(*force, before, phase.points, m_reader, m_directionRule);
    const Account account = accountOf(*phase.effect, m_reader);
    if (force && after.acceleration.rows() == 0) {
        Vec2 &momentum = balance.momentum[conserves ? Account::hand : account];
        momentum = momentum + (conserves ? m_interval.pipeline.step.h * entry.holdingForce
                                         : m_reader.momentum(after) - m_reader.momentum(before));
    }
    if (!m_reader.isStored(*phase.effect))
        balance.energy[account] += m_reader.moving(after) - m_reader.moving(before);
    if (force)
        force->add(before, phase.points, 1.0, m_directionRule, entry.acceleration);
    else
        torque->add(before, phase.points, 1.0, entry.angularAcceleration);
    if (pending.isConsumed)
        pending = {};
    pending.forces.push_back(std::move(entry));
}

void EnergyAccounting::addKick(const Phase &phase, const State &before, const State &after,
                               PendingForces &pending, Balance &balance) const
{
    pending.isConsumed = true;
    for (const PendingForce &entry : pending.forces) {
        const Account account = sim::accountOf(*entry.effect, m_reader);
        const bool stored = m_reader.isStored(*entry.effect);
        if (m_reader.turns()) {
            const Eigen::ArrayXd work =
                m_reader.mass() * entry.angularAcceleration * 0.5 * (before.spin + after.spin);
            balance.energy[account] += stored ? 0.0 : phase.kickFrames * work.sum();
            continue;
        }
        const Eigen::ArrayX2d forces = entry.acceleration.colwise() * m_reader.mass();
        const Vec2 totalForce = {forces.col(0).sum(), forces.col(1).sum()};
        const bool conserves = m_reader.conservesMomentum(*entry.effect);
        Vec2 &momentum = balance.momentum[conserves ? Account::hand : account];
        momentum = momentum + phase.kickFrames * (conserves ? entry.holdingForce : totalForce);
        if (!stored)
            balance.energy[account] +=
                phase.kickFrames * 0.5 * (forces * (before.velocity + after.velocity)).sum();
    }
}

}
