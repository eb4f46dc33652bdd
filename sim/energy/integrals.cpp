#include "sim/energy/integrals.h"

#include <cmath>

namespace sim {

namespace {

/// Puts a number a point under x and under y, or where things turn under the angles.
Eigen::ArrayXd rowsOf(const Flow &flow, const Meter &meter)
{
    const Eigen::Index points = meter.mass().size();
    Eigen::ArrayXd rows = Eigen::ArrayXd::Zero(flow.size());
    if (meter.turns())
        rows.segment(2 * points, points) = meter.mass();
    else
        rows << meter.mass(), meter.mass();
    return rows;
}

bool runsClock(const Flow &flow)
{
    for (const EffectPtr &effect : flow.effects()) {
        const auto *driver = dynamic_cast<const Driver *>(effect.get());
        if (driver && driver->pace() == Pace::flows)
            return true;
    }
    return false;
}

}

Account accountOf(const Effect &effect, const Meter &meter)
{
    if (meter.isStored(effect))
        return effect.kind() == Kind::gravity ? Account::gravity : Account::anchors;
    if (effect.kind() == Kind::wind)
        return Account::wind;
    return effect.kind() == Kind::driver ? Account::motors : Account::pulls;
}

Integrals::Integrals(const Scene &scene, const Meter &meter, Directions directions)
    : m_meter(meter), m_flow(scene, directions), m_directions(directions), m_effects(m_flow.effects()),
      m_rowMass(rowsOf(m_flow, meter)), m_rates(m_flow.size()), m_ticks(runsClock(m_flow))
{
    for (const Flow::Stretch &stretch : m_flow.stretches())
        m_rates.segment(stretch.first, stretch.count) = stretch.rate;
}

State Integrals::at(const State &begun, double time, const Eigen::ArrayXd &place) const
{
    State state = begun;
    m_flow.prepare(state);
    m_flow.tick(state, time);
    m_flow.place(place.data(), state);
    return state;
}

Eigen::ArrayXd Integrals::accelerations(State &state, const Eigen::ArrayXd &speed) const
{
    Eigen::ArrayXd a(m_flow.size());
    m_flow.accelerations(state, a.data());
    return m_rates.isInf().select(0.0, a - m_rates.isInf().select(0.0, m_rates) * speed);
}

/// What damping stops at once stays where it is.
void Integrals::stop(PathEnd &end) const
{
    end.speed = m_rates.isInf().select(0.0, end.speed);
}

double Integrals::kinetic(const Eigen::ArrayXd &speed) const
{
    return 0.5 * (m_rowMass * speed.square()).sum();
}

Vec2 Integrals::pushOf(const Eigen::ArrayXd &rate) const
{
    if (m_meter.turns())
        return {};
    const Eigen::Index points = m_flow.size() / 2;
    const Eigen::ArrayXd push = m_rowMass * rate;
    return {push.head(points).sum(), push.tail(points).sum()};
}

Vec2 heldPush(const Force &force, const State &state, Points movers, const Meter &meter,
              Directions directions)
{
    const int held = state.hold.point;
    if (held < 0 || meter.mass()[held] == 0.0)
        return {};
    Eigen::ArrayX2d pull = Eigen::ArrayX2d::Zero(state.points(), 2);
    force.add(meter.freed(state), movers, 1.0, directions, pull);
    return {-meter.mass()[held] * pull(held, 0), -meter.mass()[held] * pull(held, 1)};
}

void Integrals::addForce(const Force &force, const State &state, const Moment &now, Sums &sums) const
{
    if (m_meter.balances(force)) {
        Vec2 &hand = sums.momentum[Account::hand];
        hand = hand + now.weight * heldPush(force, state, {0, state.points()}, m_meter, m_directions);
        return;
    }
    Eigen::ArrayX2d pull = Eigen::ArrayX2d::Zero(state.points(), 2);
    force.add(state, {0, state.points()}, 1.0, m_directions, pull);
    const Eigen::ArrayXd rows = pull.reshaped();
    const Account account = accountOf(force, m_meter);
    sums.momentum[account] = sums.momentum[account] + now.weight * pushOf(rows);
    if (!m_meter.isStored(force))
        sums.energy[account] += now.weight * (m_rowMass * rows * now.speed).sum();
}

void Integrals::addTorque(const Torque &torque, const State &state, const Moment &now, Sums &sums) const
{
    if (m_meter.isStored(torque))
        return;
    Eigen::ArrayXd pull = Eigen::ArrayXd::Zero(state.points());
    torque.add(state, {0, state.points()}, 1.0, pull);
    sums.energy[accountOf(torque, m_meter)] +=
        now.weight * (m_meter.mass() * pull * now.speed.tail(state.points())).sum();
}

/// How fast clocks lift what is stored while nothing moves. By differences of order 4: Abramowitz and Stegun, 25.3.6.
double Integrals::clockPower(const State &state) const
{
    constexpr double apart = 1e-2; // frames
    const auto storedAt = [&](double time) {
        State then = state;
        m_flow.tick(then, time);
        return m_meter.stored(then);
    };
    const double near = storedAt(apart) - storedAt(-apart);
    const double far = storedAt(2.0 * apart) - storedAt(-2.0 * apart);
    return (8.0 * near - far) / (12.0 * apart);
}

void Integrals::addPowers(const State &state, const Moment &now, Sums &sums) const
{
    for (const EffectPtr &effect : m_effects) {
        if (const auto *force = dynamic_cast<const Force *>(effect.get()); force && !m_meter.turns())
            addForce(*force, state, now, sums);
        else if (const auto *torque = dynamic_cast<const Torque *>(effect.get()))
            addTorque(*torque, state, now, sums);
    }
    if (m_ticks)
        sums.energy[Account::motors] += now.weight * clockPower(state);
    const Eigen::ArrayXd slowed = m_rates.isInf().select(0.0, -m_rates * now.speed);
    sums.energy[Account::damping] += now.weight * (m_rowMass * slowed * now.speed).sum();
    sums.momentum[Account::damping] = sums.momentum[Account::damping] + now.weight * pushOf(slowed);
}

Integrals::Sums Integrals::along(const State &begun, double start, double end, const Way &way) const
{
    Sums sums;
    Eigen::ArrayXd place;
    Moment now;
    for (const GaussNode &node : gaussNodes()) {
        const double time = start + node.share * (end - start);
        way(time, place, now.speed);
        now.weight = node.weight * (end - start);
        addPowers(at(begun, time, place), now, sums);
    }
    return sums;
}

void Integrals::book(const Sums &sums, Balance &into) const
{
    for (const AccountName &name : accountNames()) {
        into.energy[name.account] += sums.energy[name.account];
        into.momentum[name.account] = into.momentum[name.account] + sums.momentum[name.account];
    }
}

void Integrals::step(const State &before, const State &after, double h, Balance &into) const
{
    const auto endAt = [&](const State &state, double time) {
        PathEnd end{Eigen::ArrayXd(m_flow.size()), Eigen::ArrayXd(m_flow.size()), {}};
        m_flow.read(state, end.place.data(), end.speed.data());
        stop(end);
        State there = at(before, time, end.place);
        end.slope = accelerations(there, end.speed);
        return end;
    };
    PathEnd start = endAt(before, 0.0);
    Eigen::ArrayXd place(m_flow.size()), speed(m_flow.size());
    m_flow.read(before, place.data(), speed.data());
    into.energy[Account::damping] += kinetic(start.speed) - kinetic(speed);
    into.momentum[Account::damping] = into.momentum[Account::damping] + pushOf(start.speed) - pushOf(speed);
    HermitePath path(std::move(start), endAt(after, h), h);
    const auto way = [&path](double time, Eigen::ArrayXd &x, Eigen::ArrayXd &v) { path.at(time, x, v); };
    const Sums sums = along(before, 0.0, h, way);
    book(sums, into);
    path.at(0.5 * h, place, speed);
    State middle = at(before, 0.5 * h, place);
    path.bend(accelerations(middle, speed) - path.middleSlope());
    const Sums bent = along(before, 0.0, h, way);
    for (const AccountName &name : accountNames())
        into.doubt += std::abs(sums.energy[name.account] - bent.energy[name.account]);
}

void Integrals::lap(const State &begun, const Lap &lap, Balance &into) const
{
    if (lap.end > lap.start)
        book(along(begun, lap.start, lap.end, lap.at), into);
    Eigen::ArrayXd place, speed;
    lap.at(lap.end, place, speed);
    const double held = m_meter.stored(at(begun, lap.end, place));
    const double holds = m_meter.stored(at(begun, lap.end, lap.nextPlace));
    into.energy[Account::impact] += holds - held + kinetic(lap.nextSpeed) - kinetic(speed);
    into.momentum[Account::impact] = into.momentum[Account::impact] + pushOf(lap.nextSpeed) - pushOf(speed);
}

}
