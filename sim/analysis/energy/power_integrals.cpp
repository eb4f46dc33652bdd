#include "sim/analysis/energy/power_integrals.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// Puts a number a point under x and under y, or where things turn under the angles.
Eigen::ArrayXd rowsOf(const OdeSystem &system, const StoredEnergyReader &reader)
{
    const Eigen::Index points = system.points();
    Eigen::ArrayXd mass(points), rows = Eigen::ArrayXd::Zero(system.size());
    Eigen::Index row = 0;
    for (const PointRange &range : system.ranges()) {
        mass.segment(row, range.count) = reader.mass().segment(range.first, range.count);
        row += range.count;
    }
    if (reader.turns())
        rows.segment(2 * points, points) = mass;
    else
        rows << mass, mass;
    return rows;
}

bool holds(const OdeSystem &system, int point)
{
    return std::any_of(system.ranges().begin(), system.ranges().end(),
                       [point](PointRange range) { return range.contains(point); });
}

bool isDriven(const OdeSystem &system)
{
    return std::any_of(system.effects().begin(), system.effects().end(),
                       [](const EffectPtr &effect) { return as<Driver>(effect) != nullptr; });
}

bool runsClock(const OdeSystem &system)
{
    for (const EffectPtr &effect : system.effects()) {
        const auto *driver = as<Driver>(effect);
        if (driver && driver->timing() == DriverTiming::continuous)
            return true;
    }
    return false;
}

}

Account accountOf(const Effect &effect, const StoredEnergyReader &reader)
{
    if (reader.isStored(effect))
        return effect.kind() == EffectKind::gravity ? Account::gravity : Account::anchors;
    if (effect.kind() == EffectKind::wind)
        return Account::wind;
    return effect.kind() == EffectKind::driver ? Account::motors : Account::pulls;
}

PowerIntegrals::PowerIntegrals(const Scene &scene, const StoredEnergyReader &reader,
                               DirectionRule directionRule)
    : m_reader(reader), m_system(scene, directionRule), m_directionRule(directionRule),
      m_effects(m_system.effects()), m_all(islandOf(m_system, reader)), m_ticks(runsClock(m_system)),
      m_drives(isDriven(m_system))
{
}

PowerIntegrals::Island PowerIntegrals::islandOf(const OdeSystem &system, const StoredEnergyReader &reader)
{
    Island island{system, rowsOf(system, reader), Eigen::ArrayXd(system.size())};
    for (const OdeSystem::RateRange &stretch : system.rateRanges())
        island.rates.segment(stretch.first, stretch.count) = stretch.rate;
    return island;
}

PowerIntegrals::Begun::Begun(const State &state) : m_first(state)
{
    m_first.stages.resize(0, 0); // nobody asks for them
    m_first.acceleration.setZero(state.pointCount(), 2);
    m_first.angularAcceleration.setZero(state.spin.rows());
    m_now = m_first;
}

State &PowerIntegrals::at(Begun &begun, const Island &island, double time, const Eigen::ArrayXd &place) const
{
    if (m_drives)
        begun.m_now = begun.m_first;
    island.system.advanceDrivers(begun.m_now, time);
    island.system.writePositions(place.data(), begun.m_now);
    return begun.m_now;
}

Eigen::ArrayXd PowerIntegrals::accelerations(State &state, const Eigen::ArrayXd &speed) const
{
    Eigen::ArrayXd a(m_system.size());
    m_system.accelerations(state, a.data());
    const Eigen::ArrayXd &rates = m_all.rates;
    return rates.isInf().select(0.0, a - rates.isInf().select(0.0, rates) * speed);
}

/// What damping stops at once stays where it is.
void PowerIntegrals::stop(PathEnd &end) const
{
    end.speed = m_all.rates.isInf().select(0.0, end.speed);
}

double PowerIntegrals::kinetic(const Island &island, const Eigen::ArrayXd &speed)
{
    return 0.5 * (island.rowMass * speed.square()).sum();
}

Vec2 PowerIntegrals::pushOf(const Island &island, const Eigen::ArrayXd &rate) const
{
    if (m_reader.turns())
        return {};
    const Eigen::Index points = island.system.points();
    const Eigen::ArrayXd push = island.rowMass * rate;
    return {push.head(points).sum(), push.tail(points).sum()};
}

Vec2 heldPush(const Force &force, const State &state, PointRange movers, const StoredEnergyReader &reader,
              DirectionRule directionRule)
{
    const int held = state.hold.point;
    if (held < 0 || reader.mass()[held] == 0.0)
        return {};
    Eigen::ArrayX2d pull = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    force.add(reader.freed(state), movers, 1.0, directionRule, pull);
    return {-reader.mass()[held] * pull(held, 0), -reader.mass()[held] * pull(held, 1)};
}

void PowerIntegrals::addForce(const Force &force, State &state, const Island &island, const Moment &now,
                              Sums &sums) const
{
    if (m_reader.conservesMomentum(force)) {
        if (!holds(island.system, state.hold.point))
            return;
        Vec2 &hand = sums.momentum[Account::hand];
        hand = hand + now.weight * heldPush(force, state, {0, state.pointCount()}, m_reader, m_directionRule);
        return;
    }
    Eigen::ArrayXd rows(island.system.size());
    island.system.forceAccelerations(force, state, rows.data());
    const Account account = accountOf(force, m_reader);
    sums.momentum[account] = sums.momentum[account] + now.weight * pushOf(island, rows);
    if (!m_reader.isStored(force))
        sums.energy[account] += now.weight * (island.rowMass * rows * now.speed).sum();
}

void PowerIntegrals::addTorque(const Torque &torque, const State &state, const Moment &now, Sums &sums) const
{
    if (m_reader.isStored(torque))
        return;
    Eigen::ArrayXd pull = Eigen::ArrayXd::Zero(state.pointCount());
    torque.add(state, {0, state.pointCount()}, 1.0, pull);
    sums.energy[accountOf(torque, m_reader)] +=
        now.weight * (m_reader.mass() * pull * now.speed.tail(state.pointCount())).sum();
}

/// How fast clocks lift what is stored while nothing moves. By differences of order 4: Abramowitz and Stegun, 25.3.6.
double PowerIntegrals::clockPower(const State &state) const
{
    constexpr double apart = 1e-2; // frames
    const auto storedAt = [&](double time) {
        State then = state;
        m_system.advanceDrivers(then, time);
        return m_reader.stored(then);
    };
    const double near = storedAt(apart) - storedAt(-apart);
    const double far = storedAt(2.0 * apart) - storedAt(-2.0 * apart);
    return (8.0 * near - far) / (12.0 * apart);
}

void PowerIntegrals::addPowers(State &state, const Island &island, const Moment &now, Sums &sums) const
{
    for (const EffectPtr &effect : m_effects) {
        if (const auto *force = as<Force>(effect); force && !m_reader.turns())
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

PowerIntegrals::Sums PowerIntegrals::along(Begun &begun, const Island &island, double start, double end,
                                           const Way &setup) const
{
    Sums sums;
    Eigen::ArrayXd place;
    Moment now;
    for (const GaussNode &node : gaussNodes()) {
        const double time = start + node.share * (end - start);
        setup(time, place, now.speed);
        now.weight = node.weight * (end - start);
        addPowers(at(begun, island, time, place), island, now, sums);
    }
    return sums;
}

void PowerIntegrals::book(const Sums &sums, Balance &into) const
{
    for (const AccountName &name : accountNames()) {
        into.energy[name.account] += sums.energy[name.account];
        into.momentum[name.account] = into.momentum[name.account] + sums.momentum[name.account];
    }
}

void PowerIntegrals::step(const State &before, const State &after, double h, Balance &into) const
{
    Begun begun(before);
    const auto endAt = [&](const State &state, double time) {
        PathEnd end{Eigen::ArrayXd(m_system.size()), Eigen::ArrayXd(m_system.size()), {}};
        m_system.readState(state, end.place.data(), end.speed.data());
        stop(end);
        end.slope = accelerations(at(begun, m_all, time, end.place), end.speed);
        return end;
    };
    const PathEnd start = endAt(before, 0.0);
    Eigen::ArrayXd place(m_system.size()), speed(m_system.size());
    m_system.readState(before, place.data(), speed.data());
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

double PowerIntegrals::lifted(Begun &begun, const Island &island, double time, const Eigen::ArrayXd &from,
                              const Eigen::ArrayXd &to) const
{
    if ((from == to).all())
        return 0.0;
    constexpr double rounding = 1e-9; // px
    const bool isPart = island.system.points() < begun.m_now.pointCount() && !m_reader.turns();
    if (!isPart || (to - from).abs().maxCoeff() > rounding) {
        const double held = m_reader.stored(at(begun, island, time, from));
        return m_reader.stored(at(begun, island, time, to)) - held;
    }
    // So little that pulls are the same all along. What the whole scene holds would cost each part the time of all.
    State &middle = at(begun, island, time, 0.5 * (from + to));
    Eigen::ArrayXd rows(island.system.size());
    double gained = 0.0;
    for (const EffectPtr &effect : m_effects) {
        const auto *force = as<Force>(effect);
        if (!force || !m_reader.isStored(*force))
            continue;
        island.system.forceAccelerations(*force, middle, rows.data());
        gained -= (island.rowMass * rows * (to - from)).sum();
    }
    return gained;
}

void PowerIntegrals::addSegment(Begun &begun, const DenseSegment &segment, Balance &into) const
{
    const Island island = islandOf(*segment.system, m_reader);
    if (segment.end > segment.start)
        book(along(begun, island, segment.start, segment.end, segment.evaluate), into);
    Eigen::ArrayXd place, speed;
    segment.evaluate(segment.end, place, speed);
    const double stored = lifted(begun, island, segment.end, place, segment.positionAfter);
    into.energy[Account::impact] += stored + kinetic(island, segment.velocityAfter) - kinetic(island, speed);
    Vec2 &push = into.momentum[Account::impact];
    push = push + pushOf(island, segment.velocityAfter) - pushOf(island, speed);
}

}
