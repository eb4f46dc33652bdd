#include "sim/flow.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace sim {

namespace {

/// The c of each point, added up over the drags that have one.
std::vector<double> ratesOf(const Scene &scene)
{
    std::vector<double> rates(static_cast<std::size_t>(scene.start.points()), 0.0);
    for (const EffectPtr &effect : scene.effects) {
        const auto drag = std::dynamic_pointer_cast<const Drag>(effect);
        for (std::size_t i = 0; drag && i < rates.size(); ++i)
            rates[i] += drag->rate(static_cast<int>(i)).value_or(0.0);
    }
    return rates;
}

/// The one finite rate among the points that go on by themselves; 0 if there is none.
std::optional<double> oneOf(const std::vector<double> &rates, const std::vector<char> &inert)
{
    std::optional<double> found;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (!inert[i] || std::isinf(rates[i]))
            continue;
        if (found && *found != rates[i])
            return {};
        found = rates[i];
    }
    return found.value_or(0.0);
}

template <class Type>
std::vector<std::shared_ptr<const Type>> all(const Scene &scene)
{
    std::vector<std::shared_ptr<const Type>> found;
    for (const EffectPtr &effect : scene.effects) {
        const auto typed = std::dynamic_pointer_cast<const Type>(effect);
        if (typed && typed->count(scene.start, {0, scene.start.points()}) > 0)
            found.push_back(typed);
    }
    return found;
}

bool hasRates(const Drag &drag, int points)
{
    for (int i = 0; i < points; ++i) {
        if (!drag.rate(i))
            return false;
    }
    return true;
}

std::size_t bytes(int numbers)
{
    return static_cast<std::size_t>(numbers) * sizeof(double);
}

}

Flow::Flow(const Scene &scene, Directions directions)
    : m_directions(directions), m_points(scene.start.points()),
      m_spins(static_cast<int>(scene.start.spin.rows())), m_size(2 * m_points + m_spins),
      m_forces(all<Force>(scene)), m_torques(all<Torque>(scene))
{
    for (int i = 0; i < m_points; ++i)
        m_inert.push_back(scene.hasInertia(i));
    for (int i = 0; i < m_points; ++i) {
        if (!m_inert[static_cast<std::size_t>(i)])
            m_idle.push_back(i);
    }
    const std::vector<double> rates = ratesOf(scene);
    for (int row = 0; row < m_size; ++row) {
        const double rate = rates[static_cast<std::size_t>(row % m_points)];
        if (m_stretches.empty() || m_stretches.back().rate != rate)
            m_stretches.push_back({row, 0, rate});
        ++m_stretches.back().count;
    }
    m_oneRate = oneOf(rates, m_inert);
    for (const auto &driver : all<Driver>(scene)) {
        if (driver->pace() == Pace::flows)
            m_flowing.push_back(driver);
        else if (driver->pace() == Pace::follows)
            m_following.push_back(driver);
    }
    for (const EffectPtr &effect : scene.effects) {
        const auto *driver = dynamic_cast<const Driver *>(effect.get());
        const auto *drag = dynamic_cast<const Drag *>(effect.get());
        if (dynamic_cast<const Force *>(effect.get()) || dynamic_cast<const Torque *>(effect.get()) ||
            (driver && driver->pace() != Pace::once) || (drag && hasRates(*drag, m_points)))
            m_effects.push_back(effect);
    }
}

EffectPtr Flow::firstJump(const Scene &scene, Contacts contacts)
{
    const Points everything = {0, scene.start.points()};
    for (const EffectPtr &effect : scene.effects) {
        if (effect->count(scene.start, everything) == 0)
            continue;
        const auto *driver = dynamic_cast<const Driver *>(effect.get());
        const auto *drag = dynamic_cast<const Drag *>(effect.get());
        const bool contact = dynamic_cast<const Contact *>(effect.get());
        if (dynamic_cast<const Constraint *>(effect.get()) || (driver && driver->pace() == Pace::once) ||
            (drag && !hasRates(*drag, everything.count)) || (contact && contacts == Contacts::doNotFit))
            return effect;
    }
    return nullptr;
}

void Flow::read(const State &state, double *q, double *v) const
{
    std::memcpy(q, state.position.data(), bytes(2 * m_points));
    std::memcpy(v, state.velocity.data(), bytes(2 * m_points));
    if (m_spins > 0) {
        std::memcpy(q + 2 * m_points, state.angle.data(), bytes(m_spins));
        std::memcpy(v + 2 * m_points, state.spin.data(), bytes(m_spins));
    }
    for (int i = 0; i < m_points; ++i) {
        if (goesOn(state, i))
            continue;
        v[i] = v[m_points + i] = 0.0;
        if (m_spins > 0)
            v[2 * m_points + i] = 0.0;
    }
}

void Flow::place(const double *q, State &state) const
{
    if (m_spins > 0)
        std::memcpy(state.angle.data(), q + 2 * m_points, bytes(m_spins));
    else
        std::memcpy(state.position.data(), q, bytes(2 * m_points));
    follow(state);
}

void Flow::push(const double *v, State &state) const
{
    for (int i = 0; i < m_points; ++i) {
        if (!goesOn(state, i))
            continue;
        state.velocity(i, 0) = v[i];
        state.velocity(i, 1) = v[m_points + i];
        if (m_spins > 0)
            state.spin[i] = v[2 * m_points + i];
    }
}

void Flow::accelerations(State &state, double *a) const
{
    const Points everything = {0, m_points};
    state.acceleration.setZero();
    for (const auto &force : m_forces)
        force->add(state, everything, 1.0, m_directions, state.acceleration);
    state.turning.setZero();
    for (const auto &torque : m_torques)
        torque->add(state, everything, 1.0, state.turning);
    gathered(state, a);
}

void Flow::gathered(State &state, double *a) const
{
    for (const int idle : m_idle)
        state.acceleration.row(idle).setZero();
    std::memcpy(a, state.acceleration.data(), bytes(2 * m_points));
    if (m_spins == 0)
        return;
    for (const int idle : m_idle)
        state.turning[idle] = 0.0;
    std::memcpy(a + 2 * m_points, state.turning.data(), bytes(m_spins));
}

bool Flow::slopes(const State &state, Slopes &into) const
{
    const Points everything = {0, m_points};
    bool known = true;
    for (const auto &force : m_forces)
        known = force->addSlopes(state, everything, 1.0, m_directions, into) && known;
    for (const auto &torque : m_torques)
        known = torque->addSlopes(state, everything, 1.0, into) && known;
    return known;
}

void Flow::tick(State &state, double h) const
{
    for (const auto &driver : m_flowing)
        driver->drive(state, h);
}

void Flow::follow(State &state) const
{
    for (const auto &driver : m_following)
        driver->drive(state, 0.0);
}

void Flow::prepare(State &state) const
{
    state.acceleration.setZero(m_points, 2);
    state.turning.setZero(m_spins);
}

}
