#include "sim/analysis/energy/power_integrals.h"

#include "sim/methods/zero_accelerations.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// Returns the mass of each row: of x and y of each point, or of each angle.
Eigen::ArrayXd rowMasses(const OdeSystem &system, const StoredEnergyReader &reader)
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

bool contains(const OdeSystem &system, int point)
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
    if (effect.kind() == EffectKind::rule)
        return Account::rule;
    return effect.kind() == EffectKind::driver ? Account::motors : Account::pulls;
}

PowerIntegrals::PowerIntegrals(const Scene &scene, const StoredEnergyReader &reader,
                               DirectionRule directionRule)
    : m_reader(reader), m_system(scene, directionRule), m_directionRule(directionRule),
      m_effects(m_system.effects()), m_wholeScene(islandOf(m_system, reader)),
      m_hasClocks(runsClock(m_system)), m_hasDrivers(isDriven(m_system))
{
}

PowerIntegrals::Island PowerIntegrals::islandOf(const OdeSystem &system, const StoredEnergyReader &reader)
{
    Island island{system, rowMasses(system, reader), Eigen::ArrayXd(system.size())};
    for (const OdeSystem::RateRange &range : system.rateRanges())
        island.rates.segment(range.first, range.count) = range.rate;
    return island;
}

PowerIntegrals::PhaseStart::PhaseStart(const State &state) : m_start(state)
{
    m_start.stages.resize(0, 0); // not needed, and large
    zeroAccelerations(m_start);
    m_scratch = m_start;
}

State &PowerIntegrals::stateAt(PhaseStart &phaseStart, const Island &island, double time,
                               const Eigen::ArrayXd &positions) const
{
    if (m_hasDrivers)
        phaseStart.m_scratch = phaseStart.m_start;
    island.system.advanceDrivers(phaseStart.m_scratch, time);
    island.system.writePositions(positions.data(), phaseStart.m_scratch);
    return phaseStart.m_scratch;
}

Eigen::ArrayXd PowerIntegrals::accelerations(State &state, const Eigen::ArrayXd &velocities) const
{
    Eigen::ArrayXd a(m_system.size());
    if (m_system.readsVelocities())
        m_system.writeVelocities(velocities.data(), state);
    m_system.accelerations(state, a.data());
    const Eigen::ArrayXd &rates = m_wholeScene.rates;
    return rates.isInf().select(0.0, a - rates.isInf().select(0.0, rates) * velocities);
}

/// Sets the velocities of rows with infinite damping to 0.
void PowerIntegrals::stopDampedRows(PathEnd &end) const
{
    end.velocities = m_wholeScene.rates.isInf().select(0.0, end.velocities);
}

double PowerIntegrals::kinetic(const Island &island, const Eigen::ArrayXd &velocities)
{
    return 0.5 * (island.rowMass * velocities.square()).sum();
}

Vec2 PowerIntegrals::massWeightedSum(const Island &island, const Eigen::ArrayXd &rate) const
{
    if (m_reader.turns())
        return {};
    const Eigen::Index points = island.system.points();
    const Eigen::ArrayXd push = island.rowMass * rate;
    return {push.head(points).sum(), push.tail(points).sum()};
}

Vec2 holdingForce(const Force &force, const State &state, PointRange movers, const StoredEnergyReader &reader,
                  DirectionRule directionRule)
{
    const int held = state.hold.point;
    if (held < 0 || reader.mass()[held] == 0.0)
        return {};
    Eigen::ArrayX2d acceleration = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    force.add(reader.freed(state), movers, 1.0, directionRule, acceleration);
    return {-reader.mass()[held] * acceleration(held, 0), -reader.mass()[held] * acceleration(held, 1)};
}

void PowerIntegrals::addForce(const Force &force, State &state, const Island &island, const Moment &moment,
                              Sums &sums) const
{
    if (m_reader.conservesMomentum(force)) {
        if (!contains(island.system, state.hold.point))
            return;
        Vec2 &hand = sums.momentum[Account::hand];
        hand = hand +
               moment.weight * holdingForce(force, state, {0, state.pointCount()}, m_reader, m_directionRule);
        return;
    }
    Eigen::ArrayXd rows(island.system.size());
    island.system.forceAccelerations(force, state, rows.data());
    const Account account = accountOf(force, m_reader);
    sums.momentum[account] = sums.momentum[account] + moment.weight * massWeightedSum(island, rows);
    if (!m_reader.isStored(force))
        sums.energy[account] += moment.weight * (island.rowMass * rows * moment.velocities).sum();
}

void PowerIntegrals::addTorque(const Torque &torque, const State &state, const Moment &moment,
                               Sums &sums) const
{
    if (m_reader.isStored(torque))
        return;
    Eigen::ArrayXd pull = Eigen::ArrayXd::Zero(state.pointCount());
    torque.add(state, {0, state.pointCount()}, 1.0, pull);
    sums.energy[accountOf(torque, m_reader)] +=
        moment.weight * (m_reader.mass() * pull * moment.velocities.tail(state.pointCount())).sum();
}

/// Returns the stored energy per frame that clocks supply while no point moves. Uses central differences of
/// order 4: Abramowitz and Stegun, 25.3.6.
double PowerIntegrals::clockPower(const State &state) const
{
    constexpr double delta = 1e-2; // frames
    const auto storedAt = [&](double time) {
        State then = state;
        m_system.advanceDrivers(then, time);
        return m_reader.stored(then);
    };
    const double near = storedAt(delta) - storedAt(-delta);
    const double far = storedAt(2.0 * delta) - storedAt(-2.0 * delta);
    return (8.0 * near - far) / (12.0 * delta);
}

void PowerIntegrals::addPowers(State &state, const Island &island, const Moment &moment, Sums &sums) const
{
    if (island.system.readsVelocities())
        island.system.writeVelocities(moment.velocities.data(), state);
    for (const EffectPtr &effect : m_effects) {
        if (const auto *force = as<Force>(effect); force && !m_reader.turns())
            addForce(*force, state, island, moment, sums);
        else if (const auto *torque = as<Torque>(effect))
            addTorque(*torque, state, moment, sums);
    }
    if (m_hasClocks)
        sums.energy[Account::motors] += moment.weight * clockPower(state);
    const Eigen::ArrayXd slowed = island.rates.isInf().select(0.0, -island.rates * moment.velocities);
    sums.energy[Account::damping] += moment.weight * (island.rowMass * slowed * moment.velocities).sum();
    sums.momentum[Account::damping] =
        sums.momentum[Account::damping] + moment.weight * massWeightedSum(island, slowed);
}

PowerIntegrals::Sums PowerIntegrals::integrate(PhaseStart &phaseStart, const Island &island, double start,
                                               double end, const Path &path) const
{
    Sums sums;
    Eigen::ArrayXd positions;
    Moment moment;
    for (const GaussNode &node : gaussNodes()) {
        const double time = start + node.position * (end - start);
        path(time, positions, moment.velocities);
        moment.weight = node.weight * (end - start);
        addPowers(stateAt(phaseStart, island, time, positions), island, moment, sums);
    }
    return sums;
}

void PowerIntegrals::add(const Sums &sums, Balance &balance) const
{
    for (const AccountName &name : accountNames()) {
        balance.energy[name.account] += sums.energy[name.account];
        balance.momentum[name.account] = balance.momentum[name.account] + sums.momentum[name.account];
    }
}

void PowerIntegrals::step(const State &before, const State &after, double h, Balance &balance) const
{
    PhaseStart phaseStart(before);
    const auto endAt = [&](const State &state, double time) {
        PathEnd end{Eigen::ArrayXd(m_system.size()), Eigen::ArrayXd(m_system.size()), {}};
        m_system.readState(state, end.positions.data(), end.velocities.data());
        stopDampedRows(end);
        end.accelerations =
            accelerations(stateAt(phaseStart, m_wholeScene, time, end.positions), end.velocities);
        return end;
    };
    const PathEnd start = endAt(before, 0.0);
    Eigen::ArrayXd positions(m_system.size()), velocities(m_system.size());
    m_system.readState(before, positions.data(), velocities.data());
    balance.energy[Account::damping] +=
        kinetic(m_wholeScene, start.velocities) - kinetic(m_wholeScene, velocities);
    balance.momentum[Account::damping] = balance.momentum[Account::damping] +
                                         massWeightedSum(m_wholeScene, start.velocities) -
                                         massWeightedSum(m_wholeScene, velocities);
    HermitePath path(start, endAt(after, h), h);
    const auto evaluate = [&path](double time, Eigen::ArrayXd &x, Eigen::ArrayXd &v) {
        path.evaluate(time, x, v);
    };
    const Sums sums = integrate(phaseStart, m_wholeScene, 0.0, h, evaluate);
    add(sums, balance);
    path.evaluate(0.5 * h, positions, velocities);
    path.setMiddleAcceleration(
        accelerations(stateAt(phaseStart, m_wholeScene, 0.5 * h, positions), velocities));
    const Sums corrected = integrate(phaseStart, m_wholeScene, 0.0, h, evaluate);
    for (const AccountName &name : accountNames())
        balance.errorEstimate += std::abs(sums.energy[name.account] - corrected.energy[name.account]);
}

double PowerIntegrals::storedEnergyChange(PhaseStart &phaseStart, const Island &island, double time,
                                          const Eigen::ArrayXd &from, const Eigen::ArrayXd &to) const
{
    if ((from == to).all())
        return 0.0;
    constexpr double rounding = 1e-9; // px
    const bool isOneIslandOfMany =
        island.system.points() < phaseStart.m_scratch.pointCount() && !m_reader.turns();
    if (!isOneIslandOfMany || (to - from).abs().maxCoeff() > rounding) {
        const double storedBefore = m_reader.stored(stateAt(phaseStart, island, time, from));
        return m_reader.stored(stateAt(phaseStart, island, time, to)) - storedBefore;
    }
    // The island moves so little that forces are constant. Reading the stored energy of the whole scene for
    // each island would be slow.
    State &middle = stateAt(phaseStart, island, time, 0.5 * (from + to));
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

void PowerIntegrals::addSegment(PhaseStart &phaseStart, const DenseSegment &segment, Balance &balance) const
{
    const Island island = islandOf(*segment.system, m_reader);
    if (segment.end > segment.start)
        add(integrate(phaseStart, island, segment.start, segment.end, segment.evaluate), balance);
    Eigen::ArrayXd positions, velocities;
    segment.evaluate(segment.end, positions, velocities);
    const double stored =
        storedEnergyChange(phaseStart, island, segment.end, positions, segment.positionAfter);
    balance.energy[Account::impact] +=
        stored + kinetic(island, segment.velocityAfter) - kinetic(island, velocities);
    Vec2 &push = balance.momentum[Account::impact];
    push = push + massWeightedSum(island, segment.velocityAfter) - massWeightedSum(island, velocities);
}

}
