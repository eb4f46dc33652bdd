#include "sim/methods/ode_system.h"

#include "sim/methods/zero_accelerations.h"
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

/// Returns the damping rate of each point of `ranges`: the sum over all drags that have one.
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

/// Returns the finite rate that all points with `movesByVelocity` share. See uniformRate().
std::optional<double> uniformRateOf(const std::vector<double> &rates,
                                    const std::vector<char> &movesByVelocity)
{
    std::optional<double> found;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (!movesByVelocity[i] || std::isinf(rates[i]))
            continue;
        if (found && *found != rates[i])
            return {};
        found = rates[i];
    }
    return found.value_or(0.0);
}

/// Returns the effects of a kind that act on points of `ranges`.
template <class Type>
std::vector<std::shared_ptr<const Type>> effectsOn(const Scene &scene, const std::vector<PointRange> &ranges)
{
    std::vector<std::shared_ptr<const Type>> found;
    for (const EffectPtr &effect : scene.effects) {
        const auto typed = sharedAs<Type>(effect);
        const auto acts = [&](PointRange range) { return typed->count(scene.start, range) > 0; };
        if (typed && std::any_of(ranges.begin(), ranges.end(), acts))
            found.push_back(typed);
    }
    return found;
}

bool hasRates(const Drag &drag, const std::vector<PointRange> &ranges)
{
    return std::all_of(ranges.begin(), ranges.end(),
                       [&](PointRange range) { return hasDampingRate(drag, range); });
}

/// Copies numbers in a loop, which is faster for a few numbers than a call of memcpy. See sim/CMakeLists.txt.
/// The two ranges must not overlap.
void copy(const double *from, int count, double *to)
{
    SIM_INDEPENDENT_ITERATIONS
    for (int i = 0; i < count; ++i)
        to[i] = from[i];
}

/// Copies the numbers of `range` in both columns to `row` in q and `distance` rows after it.
void copy(const Eigen::ArrayX2d &columns, PointRange range, double *row, int distance)
{
    copy(&columns(range.first, 0), range.count, row);
    copy(&columns(range.first, 1), range.count, row + distance);
}
/// Copies them back.
void copy(const double *row, int distance, Eigen::ArrayX2d &columns, PointRange range)
{
    copy(row, range.count, &columns(range.first, 0));
    copy(row + distance, range.count, &columns(range.first, 1));
}

}

bool hasDampingRate(const Drag &drag, PointRange points)
{
    for (int i = points.first; i < points.end(); ++i) {
        if (!drag.dampingRate(i))
            return false;
    }
    return true;
}

OdeSystem::OdeSystem(const Scene &scene, DirectionRule directionRule)
    : OdeSystem(scene, directionRule, {{0, scene.start.pointCount()}})
{
}

OdeSystem::OdeSystem(const Scene &scene, DirectionRule directionRule, std::vector<PointRange> ranges)
    : m_directionRule(directionRule), m_ranges(std::move(ranges)), m_points(countOf(m_ranges)),
      m_spins(scene.start.spin.rows() > 0 ? m_points : 0), m_size(2 * m_points + m_spins),
      m_forces(effectsOn<Force>(scene, m_ranges)), m_torques(effectsOn<Torque>(scene, m_ranges))
{
    forEachPoint([&](int point, int) {
        m_movesByVelocity.push_back(scene.movesByVelocity(point));
        if (!m_movesByVelocity.back())
            m_prescribedPoints.push_back(point);
    });
    m_readsVelocities = firstVelocityForce() != nullptr;
    for (const auto &force : m_forces)
        m_adders.push_back(force->adderFor(m_ranges));
    const std::vector<double> rates = ratesOf(scene, m_ranges);
    for (int row = 0; row < m_size; ++row) {
        const double rate = rates[static_cast<std::size_t>(row % m_points)];
        if (m_rateRanges.empty() || m_rateRanges.back().rate != rate)
            m_rateRanges.push_back({row, 0, rate});
        ++m_rateRanges.back().count;
    }
    m_uniformRate = uniformRateOf(rates, m_movesByVelocity);
    for (const auto &driver : effectsOn<Driver>(scene, {{0, scene.start.pointCount()}})) {
        if (driver->timing() == DriverTiming::continuous)
            m_continuousDrivers.push_back(driver);
        else if (driver->timing() == DriverTiming::dependent)
            m_dependentDrivers.push_back(driver);
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
            (drag && !hasDampingRate(*drag, everything)) || (contact && contacts == Contacts::excluded))
            return effect;
    }
    return nullptr;
}

EffectPtr OdeSystem::firstVelocityForce() const
{
    for (const auto &force : m_forces) {
        if (force->dependsOnVelocity())
            return force;
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
    forEachRange([&](PointRange range, int row) {
        copy(state.position, range, q + row, m_points);
        copy(state.velocity, range, v + row, m_points);
        if (m_spins > 0) {
            copy(&state.angle[range.first], range.count, q + 2 * m_points + row);
            copy(&state.spin[range.first], range.count, v + 2 * m_points + row);
        }
    });
    forEachPoint([&](int point, int row) {
        if (movesByVelocity(state, point, row))
            return;
        v[row] = v[m_points + row] = 0.0;
        if (m_spins > 0)
            v[2 * m_points + row] = 0.0;
    });
}

void OdeSystem::writePositions(const double *q, State &state) const
{
    forEachRange([&](PointRange range, int row) {
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
    forEachPoint([&](int point, int row) {
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
    for (const AccelerationAdder &add : m_adders)
        add(state, state.acceleration);
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
    copyAccelerations(state, a);
}

void OdeSystem::copyAccelerations(const State &state, double *a) const
{
    forEachRange([&](PointRange range, int row) {
        copy(state.acceleration, range, a + row, m_points);
        if (m_spins > 0)
            copy(&state.angularAcceleration[range.first], range.count, a + 2 * m_points + row);
    });
}

void OdeSystem::readAccumulated(State &state, double *a) const
{
    for (const int point : m_prescribedPoints) {
        state.acceleration.row(point).setZero();
        if (m_spins > 0)
            state.angularAcceleration[point] = 0.0;
    }
    copyAccelerations(state, a);
}

bool OdeSystem::jacobian(const State &state, Jacobian &jacobian) const
{
    bool isComplete = true;
    for (const PointRange &range : m_ranges) {
        for (const auto &force : m_forces)
            isComplete = force->addJacobian(state, range, 1.0, m_directionRule, jacobian) && isComplete;
        for (const auto &torque : m_torques)
            isComplete = torque->addJacobian(state, range, 1.0, jacobian) && isComplete;
    }
    return isComplete;
}

void OdeSystem::advanceDrivers(State &state, double h) const
{
    for (const auto &driver : m_continuousDrivers)
        driver->drive(state, h);
}

void OdeSystem::runDependentDrivers(State &state) const
{
    for (const auto &driver : m_dependentDrivers)
        driver->drive(state, 0.0);
}

void OdeSystem::prepare(State &state) const
{
    zeroAccelerations(state);
}

}
