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
        return effect->kind() == Kind::contact ? Account::impact : Account::sticks;
    if (const auto *driver = as<Driver>(phase.effect)) {
        if (driver->pace() == Pace::follows)
            return Account::hand; // it only stops what is held
        return effect->kind() == Kind::wind ? Account::wind : Account::motors;
    }
    if (!effect && !phase.moves && phase.kicks == 0.0)
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
    return driver && driver->pace() == Pace::flows;
}

}

Books::Books(const Segment &segment, Directions directions)
    : m_segment(segment), m_directions(directions), m_meter(segment.scene),
      m_integrals(segment.scene, m_meter, directions)
{
}

void Books::row(State &state, Balance &into) const
{
    const FlushTiny flush;
    for (int i = 0; i < m_segment.pipeline.step.perRow; ++i)
        step(state, into);
}

void Books::step(State &state, Balance &into) const
{
    const std::vector<Phase> &phases = m_segment.pipeline.phases;
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

void Books::wholeStep(State &state, std::size_t first, std::size_t last, Balance &into) const
{
    const std::vector<Phase> &phases = m_segment.pipeline.phases;
    const State before = state;
    if (const auto &byLaps = phases[first].runByLaps) {
        Integrals::Begun begun(before);
        byLaps(state, [&](const Lap &lap) { m_integrals.lap(begun, lap, into); });
        return;
    }
    for (std::size_t i = first; i <= last; ++i)
        phases[i].run(state);
    m_integrals.step(before, state, m_segment.pipeline.step.h, into);
}

void Books::onePhase(const Phase &phase, State &state, Open &open, Balance &into) const
{
    const State before = state;
    phase.run(state);
    if (isForce(phase))
        gather(phase, before, state, open.gathering, into);
    else if (phase.kicks > 0.0)
        kick(phase, before, state, open.gathering, into);
    else if (isClock(phase))
        open.ticks.push_back({before, state});
    else if (const std::optional<Account> account = accountOf(phase))
        change(*account, before, state, into);
}

void Books::clock(const Tick &tick, const State &start, const State &end, Balance &into) const
{
    for (const State *moment : {&start, &end}) {
        State before = tick.before, after = tick.after;
        before.position = after.position = moment->position;
        before.angle = after.angle = moment->angle;
        into.energy[Account::motors] += 0.5 * (m_meter.stored(after) - m_meter.stored(before));
    }
}

void Books::change(Account account, const State &before, const State &after, Balance &into) const
{
    const Stock was = m_meter.read(before), is = m_meter.read(after);
    into.energy[account] += is.total() - was.total();
    into.momentum[account] = into.momentum[account] + is.momentum - was.momentum;
}

/// A force acts on velocities at once, or it is gathered for a kick to come.
void Books::gather(const Phase &phase, const State &before, const State &after, Gathering &gathering,
                   Balance &into) const
{
    const auto *force = as<Force>(phase.effect);
    const auto *torque = as<Torque>(phase.effect);
    Gathered one{
        phase.effect, Eigen::ArrayX2d::Zero(before.points(), 2), Eigen::ArrayXd::Zero(before.points()), {}};
    const bool balances = m_meter.balances(*phase.effect);
    if (force && balances)
        one.heldPush = heldPush(*force, before, phase.points, m_meter, m_directions);
    const Account account = accountOf(*phase.effect, m_meter);
    if (force && after.acceleration.rows() == 0) {
        Vec2 &push = into.momentum[balances ? Account::hand : account];
        push = push + (balances ? m_segment.pipeline.step.h * one.heldPush
                                : m_meter.momentum(after) - m_meter.momentum(before));
    }
    if (!m_meter.isStored(*phase.effect))
        into.energy[account] += m_meter.moving(after) - m_meter.moving(before);
    if (force)
        force->add(before, phase.points, 1.0, m_directions, one.pull);
    else
        torque->add(before, phase.points, 1.0, one.turn);
    if (gathering.isSpent)
        gathering = {};
    gathering.forces.push_back(std::move(one));
}

void Books::kick(const Phase &phase, const State &before, const State &after, Gathering &gathering,
                 Balance &into) const
{
    gathering.isSpent = true;
    for (const Gathered &one : gathering.forces) {
        const Account account = sim::accountOf(*one.effect, m_meter);
        const bool stored = m_meter.isStored(*one.effect);
        if (m_meter.turns()) {
            const Eigen::ArrayXd work = m_meter.mass() * one.turn * 0.5 * (before.spin + after.spin);
            into.energy[account] += stored ? 0.0 : phase.kicks * work.sum();
            continue;
        }
        const Eigen::ArrayX2d push = one.pull.colwise() * m_meter.mass();
        const Vec2 sum = {push.col(0).sum(), push.col(1).sum()};
        const bool balances = m_meter.balances(*one.effect);
        Vec2 &given = into.momentum[balances ? Account::hand : account];
        given = given + phase.kicks * (balances ? one.heldPush : sum);
        if (!stored)
            into.energy[account] += phase.kicks * 0.5 * (push * (before.velocity + after.velocity)).sum();
    }
}

}
