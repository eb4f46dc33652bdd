#include "sim/analysis/energy/power_integrals.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// Puts a number a point under x and under y, or where things turn under the angles.
Eigen::ArrayXd rowsOf(const Flow &flow, const Meter &meter)
{
    const Eigen::Index points = flow.points();
    Eigen::ArrayXd mass(points), rows = Eigen::ArrayXd::Zero(flow.size());
    Eigen::Index row = 0;
    for (const Points &run : flow.runs()) {
        mass.segment(row, run.count) = meter.mass().segment(run.first, run.count);
        row += run.count;
    }
    if (meter.turns())
        rows.segment(2 * points, points) = mass;
    else
        rows << mass, mass;
    return rows;
}

bool holds(const Flow &flow, int point)
{
    return std::any_of(flow.runs().begin(), flow.runs().end(),
                       [point](Points run) { return run.contains(point); });
}

bool isDriven(const Flow &flow)
{
    return std::any_of(flow.effects().begin(), flow.effects().end(),
                       [](const EffectPtr &effect) { return as<Driver>(effect) != nullptr; });
}

bool runsClock(const Flow &flow)
{
    for (const EffectPtr &effect : flow.effects()) {
        const auto *driver = as<Driver>(effect);
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
      m_all(islandOf(m_flow, meter)), m_ticks(runsClock(m_flow)), m_drives(isDriven(m_flow))
{
}

Integrals::Island Integrals::islandOf(const Flow &flow, const Meter &meter)
{
    Island island{flow, rowsOf(flow, meter), Eigen::ArrayXd(flow.size())};
    for (const Flow::Stretch &stretch : flow.stretches())
        island.rates.segment(stretch.first, stretch.count) = stretch.rate;
    return island;
}

Integrals::Begun::Begun(const State &state) : m_first(state)
{
    m_first.stages.resize(0, 0); // nobody asks for them
    m_first.acceleration.setZero(state.points(), 2);
    m_first.turning.setZero(state.spin.rows());
    m_now = m_first;
}

State &Integrals::at(Begun &begun, const Island &island, double time, const Eigen::ArrayXd &place) const
{
    if (m_drives)
        begun.m_now = begun.m_first;
    island.flow.tick(begun.m_now, time);
    island.flow.place(place.data(), begun.m_now);
    return begun.m_now;
}

Eigen::ArrayXd Integrals::accelerations(State &state, const Eigen::ArrayXd &speed) const
{
    Eigen::ArrayXd a(m_flow.size());
    m_flow.accelerations(state, a.data());
    const Eigen::ArrayXd &rates = m_all.rates;
    return rates.isInf().select(0.0, a - rates.isInf().select(0.0, rates) * speed);
}

/// What damping stops at once stays where it is.
void Integrals::stop(PathEnd &end) const
{
    end.speed = m_all.rates.isInf().select(0.0, end.speed);
}

double Integrals::kinetic(const Island &island, const Eigen::ArrayXd &speed)
{
    return 0.5 * (island.rowMass * speed.square()).sum();
}

Vec2 Integrals::pushOf(const Island &island, const Eigen::ArrayXd &rate) const
{
    if (m_meter.turns())
        return {};
    const Eigen::Index points = island.flow.points();
    const Eigen::ArrayXd push = island.rowMass * rate;
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

void Integrals::addForce(const Force &force, State &state, const Island &island, const Moment &now,
                         Sums &sums) const
{
    if (m_meter.balances(force)) {
        if (!holds(island.flow, state.hold.point))
            return;
        Vec2 &hand = sums.momentum[Account::hand];
        hand = hand + now.weight * heldPush(force, state, {0, state.points()}, m_meter, m_directions);
        return;
    }
    Eigen::ArrayXd rows(island.flow.size());
    island.flow.pull(force, state, rows.data());
    const Account account = accountOf(force, m_meter);
    sums.momentum[account] = sums.momentum[account] + now.weight * pushOf(island, rows);
    if (!m_meter.isStored(force))
        sums.energy[account] += now.weight * (island.rowMass * rows * now.speed).sum();
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

void Integrals::addPowers(State &state, const Island &island, const Moment &now, Sums &sums) const
{
    for (const EffectPtr &effect : m_effects) {
        if (const auto *force = as<Force>(effect); force && !m_meter.turns())
            addForce(*force, state, island, now, sums);
        else if (const auto *torque = as<Torque>(effect))
            addTorque(*torque, state, now, sums);
    }
    if (m_ticks)
        sums.energy[Account::motors] += now.weight * clockPower(state);
    const Eigen::ArrayXd slowed = island.rates.isInf().select(0.0, -island.rates * now.speed);
    sums.energy[Account::damping] += now.weight * (island.rowMass * slowed * now.speed).sum();
    sums.momentum[Account::damping] = sums.momentum[Account::damping] + now.weight * pushOf(island, slowed);
}

Integrals::Sums Integrals::along(Begun &begun, const Island &island, double start, double end,
                                 const Way &way) const
{
    Sums sums;
    Eigen::ArrayXd place;
    Moment now;
    for (const GaussNode &node : gaussNodes()) {
        const double time = start + node.share * (end - start);
        way(time, place, now.speed);
        now.weight = node.weight * (end - start);
        addPowers(at(begun, island, time, place), island, now, sums);
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
    Begun begun(before);
    const auto endAt = [&](const State &state, double time) {
        PathEnd end{Eigen::ArrayXd(m_flow.size()), Eigen::ArrayXd(m_flow.size()), {}};
        m_flow.read(state, end.place.data(), end.speed.data());
        stop(end);
        end.slope = accelerations(at(begun, m_all, time, end.place), end.speed);
        return end;
    };
    const PathEnd start = endAt(before, 0.0);
    Eigen::ArrayXd place(m_flow.size()), speed(m_flow.size());
    m_flow.read(before, place.data(), speed.data());
    into.energy[Account::damping] += kinetic(m_all, start.speed) - kinetic(m_all, speed);
    into.momentum[Account::damping] =
        into.momentum[Account::damping] + pushOf(m_all, start.speed) - pushOf(m_all, speed);
    HermitePath path(start, endAt(after, h), h);
    const auto way = [&path](double time, Eigen::ArrayXd &x, Eigen::ArrayXd &v) { path.at(time, x, v); };
    const Sums sums = along(begun, m_all, 0.0, h, way);
    book(sums, into);
    path.at(0.5 * h, place, speed);
    path.bend(accelerations(at(begun, m_all, 0.5 * h, place), speed));
    const Sums bent = along(begun, m_all, 0.0, h, way);
    for (const AccountName &name : accountNames())
        into.doubt += std::abs(sums.energy[name.account] - bent.energy[name.account]);
}

double Integrals::lifted(Begun &begun, const Island &island, double time, const Eigen::ArrayXd &from,
                         const Eigen::ArrayXd &to) const
{
    if ((from == to).all())
        return 0.0;
    constexpr double rounding = 1e-9; // px
    const bool isPart = island.flow.points() < begun.m_now.points() && !m_meter.turns();
    if (!isPart || (to - from).abs().maxCoeff() > rounding) {
        const double held = m_meter.stored(at(begun, island, time, from));
        return m_meter.stored(at(begun, island, time, to)) - held;
    }
    // So little that pulls are the same all along. What the whole scene holds would cost each part the time of all.
    State &middle = at(begun, island, time, 0.5 * (from + to));
    Eigen::ArrayXd rows(island.flow.size());
    double gained = 0.0;
    for (const EffectPtr &effect : m_effects) {
        const auto *force = as<Force>(effect);
        if (!force || !m_meter.isStored(*force))
            continue;
        island.flow.pull(*force, middle, rows.data());
        gained -= (island.rowMass * rows * (to - from)).sum();
    }
    return gained;
}

void Integrals::lap(Begun &begun, const Lap &lap, Balance &into) const
{
    const Island island = islandOf(*lap.flow, m_meter);
    if (lap.end > lap.start)
        book(along(begun, island, lap.start, lap.end, lap.at), into);
    Eigen::ArrayXd place, speed;
    lap.at(lap.end, place, speed);
    const double stored = lifted(begun, island, lap.end, place, lap.nextPlace);
    into.energy[Account::impact] += stored + kinetic(island, lap.nextSpeed) - kinetic(island, speed);
    Vec2 &push = into.momentum[Account::impact];
    push = push + pushOf(island, lap.nextSpeed) - pushOf(island, speed);
}

}
