#include "sim/methods/ode_system.h"

#include "sim/simd/point_kernels.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

int countOf(const std::vector<PointRange> &ranges)
{
    int count = 0;
    for (const PointRange &range : ranges)
        count += range.count;
    return count;
}

/// The c of each point of `runs`, added up over the drags that have one.
std::vector<double> ratesOf(const Scene &scene, const std::vector<PointRange> &ranges)
{
    std::vector<double> rates(static_cast<std::size_t>(countOf(ranges)), 0.0);
    for (const EffectPtr &effect : scene.effects) {
        const auto *drag = as<Drag>(effect);
        std::size_t row = 0;
        for (const PointRange &range : ranges) {
            for (int i = range.first; drag && i < range.end(); ++i)
                rates[row++] += drag->dampingRate(i).value_or(0.0);
        }
    }
    return rates;
}

/// The one finite rate among the points that go on by themselves; 0 if there is none.
std::optional<double> oneOf(const std::vector<double> &rates, const std::vector<char> &movingRanges)
{
    std::optional<double> found;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (!movingRanges[i] || std::isinf(rates[i]))
            continue;
        if (found && *found != rates[i])
            return {};
        found = rates[i];
    }
    return found.value_or(0.0);
}

/// The effects of a kind that work on points of `runs`.
template <class Type>
std::vector<std::shared_ptr<const Type>> all(const Scene &scene, const std::vector<PointRange> &ranges)
{
    std::vector<std::shared_ptr<const Type>> found;
    for (const EffectPtr &effect : scene.effects) {
        const auto typed = sharedAs<Type>(effect);
        const auto works = [&](PointRange range) { return typed->count(scene.start, range) > 0; };
        if (typed && std::any_of(ranges.begin(), ranges.end(), works))
            found.push_back(typed);
    }
    return found;
}

bool hasRates(const Drag &drag, const std::vector<PointRange> &ranges)
{
    for (const PointRange &range : ranges) {
        for (int i = range.first; i < range.end(); ++i) {
            if (!drag.dampingRate(i))
                return false;
        }
    }
    return true;
}

/// As loops, which are quicker for a few numbers than a call of memcpy: see sim/CMakeLists.txt.
void copy(const double *from, int count, double *into)
{
    for (int i = 0; i < count; ++i)
        into[i] = from[i];
}

/// The numbers of `run` in both columns, to and from rows of q that lie `apart`.
void copy(const Eigen::ArrayX2d &columns, PointRange range, double *row, int apart)
{
    copy(&columns(range.first, 0), range.count, row);
    copy(&columns(range.first, 1), range.count, row + apart);
}
void copy(const double *row, int apart, Eigen::ArrayX2d &columns, PointRange range)
{
    copy(row, range.count, &columns(range.first, 0));
    copy(row + apart, range.count, &columns(range.first, 1));
}

}

OdeSystem::OdeSystem(const Scene &scene, DirectionRule directionRule)
    : OdeSystem(scene, directionRule, {{0, scene.start.pointCount()}})
{
}

OdeSystem::OdeSystem(const Scene &scene, DirectionRule directionRule, std::vector<PointRange> ranges)
    : m_directionRule(directionRule), m_ranges(std::move(ranges)), m_points(countOf(m_ranges)),
      m_spins(scene.start.spin.rows() > 0 ? m_points : 0), m_size(2 * m_points + m_spins),
      m_forces(all<Force>(scene, m_ranges)), m_torques(all<Torque>(scene, m_ranges))
{
    forEach([&](int point, int) {
        m_inert.push_back(scene.movesByVelocity(point));
        if (!m_inert.back())
            m_idle.push_back(point);
    });
    for (const auto &force : m_forces)
        m_pulls.push_back(force->adderFor(m_ranges));
    const std::vector<double> rates = ratesOf(scene, m_ranges);
    for (int row = 0; row < m_size; ++row) {
        const double rate = rates[static_cast<std::size_t>(row % m_points)];
        if (m_rateRanges.empty() || m_rateRanges.back().rate != rate)
            m_rateRanges.push_back({row, 0, rate});
        ++m_rateRanges.back().count;
    }
    m_oneRate = oneOf(rates, m_inert);
    for (const auto &driver : all<Driver>(scene, {{0, scene.start.pointCount()}})) {
        if (driver->timing() == DriverTiming::continuous)
            m_flowing.push_back(driver);
        else if (driver->timing() == DriverTiming::dependent)
            m_following.push_back(driver);
    }
    listEffects(scene);
}

void OdeSystem::listEffects(const Scene &scene)
{
    for (const EffectPtr &effect : scene.effects) {
        const auto *driver = as<Driver>(effect);
        const auto *drag = as<Drag>(effect);
        if (as<Force>(effect) || as<Torque>(effect) ||
            (driver && driver->timing() != DriverTiming::impulsive) || (drag && hasRates(*drag, m_ranges)))
            m_effects.push_back(effect);
    }
}

EffectPtr OdeSystem::firstDiscontinuity(const Scene &scene, Contacts contacts)
{
    const PointRange everything = {0, scene.start.pointCount()};
    for (const EffectPtr &effect : scene.effects) {
        if (effect->count(scene.start, everything) == 0)
            continue;
        const auto *driver = as<Driver>(effect);
        const auto *drag = as<Drag>(effect);
        const bool contact = as<Contact>(effect);
        if (as<Constraint>(effect) || (driver && driver->timing() == DriverTiming::impulsive) ||
            (drag && !hasRates(*drag, {everything})) || (contact && contacts == Contacts::excluded))
            return effect;
    }
    return nullptr;
}

int OdeSystem::pointAt(int row) const
{
    for (const PointRange &range : m_ranges) {
        if (row < range.count)
            return range.first + row;
        row -= range.count;
    }
    return -1;
}

void OdeSystem::readState(const State &state, double *q, double *v) const
{
    forEachRun([&](PointRange range, int row) {
        copy(state.position, range, q + row, m_points);
        copy(state.velocity, range, v + row, m_points);
        if (m_spins > 0) {
            copy(&state.angle[range.first], range.count, q + 2 * m_points + row);
            copy(&state.spin[range.first], range.count, v + 2 * m_points + row);
        }
    });
    forEach([&](int point, int row) {
        if (movesByVelocity(state, point, row))
            return;
        v[row] = v[m_points + row] = 0.0;
        if (m_spins > 0)
            v[2 * m_points + row] = 0.0;
    });
}

void OdeSystem::writePositions(const double *q, State &state) const
{
    forEachRun([&](PointRange range, int row) {
        if (m_spins > 0) {
            copy(q + 2 * m_points + row, range.count, &state.angle[range.first]);
            return;
        }
        copy(q + row, m_points, state.position, range);
    });
    runDependentDrivers(state);
}

void OdeSystem::writeVelocities(const double *v, State &state) const
{
    forEach([&](int point, int row) {
        if (!movesByVelocity(state, point, row))
            return;
        state.velocity(point, 0) = v[row];
        state.velocity(point, 1) = v[m_points + row];
        if (m_spins > 0)
            state.spin[point] = v[2 * m_points + row];
    });
}

void OdeSystem::clear(State &state) const
{
    for (const PointRange &range : m_ranges) {
        sim::setZero(state.acceleration, range);
        if (m_spins > 0)
            state.angularAcceleration.segment(range.first, range.count).setZero();
    }
}

void OdeSystem::accelerations(State &state, double *a) const
{
    clear(state);
    for (const AccelerationAdder &pull : m_pulls)
        pull(state, state.acceleration);
    for (const auto &torque : m_torques) {
        for (const PointRange &range : m_ranges)
            torque->add(state, range, 1.0, state.angularAcceleration);
    }
    readAccumulated(state, a);
}

void OdeSystem::forceAccelerations(const Force &force, State &state, double *a) const
{
    clear(state);
    for (const PointRange &range : m_ranges)
        force.add(state, range, 1.0, m_directionRule, state.acceleration);
    take(state, a);
}

void OdeSystem::take(const State &state, double *a) const
{
    forEachRun([&](PointRange range, int row) {
        copy(state.acceleration, range, a + row, m_points);
        if (m_spins > 0)
            copy(&state.angularAcceleration[range.first], range.count, a + 2 * m_points + row);
    });
}

void OdeSystem::readAccumulated(State &state, double *a) const
{
    for (const int idle : m_idle) {
        state.acceleration.row(idle).setZero();
        if (m_spins > 0)
            state.angularAcceleration[idle] = 0.0;
    }
    take(state, a);
}

bool OdeSystem::jacobian(const State &state, Jacobian &jacobian) const
{
    bool known = true;
    for (const PointRange &range : m_ranges) {
        for (const auto &force : m_forces)
            known = force->addJacobian(state, range, 1.0, m_directionRule, jacobian) && known;
        for (const auto &torque : m_torques)
            known = torque->addJacobian(state, range, 1.0, jacobian) && known;
    }
    return known;
}

void OdeSystem::advanceDrivers(State &state, double h) const
{
    for (const auto &driver : m_flowing)
        driver->drive(state, h);
}

void OdeSystem::runDependentDrivers(State &state) const
{
    for (const auto &driver : m_following)
        driver->drive(state, 0.0);
}

void OdeSystem::prepare(State &state) const
{
    state.acceleration.setZero(state.pointCount(), 2);
    state.angularAcceleration.setZero(state.spin.rows());
}

}
