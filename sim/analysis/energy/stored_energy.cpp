#include "sim/analysis/energy/stored_energy.h"

#include <algorithm>

namespace sim {

namespace {

/// Returns 1/mass of every point that moves by its velocity, 0 of the others.
Eigen::ArrayXd inverseMassOf(const Scene &scene)
{
    Eigen::ArrayXd inverse = scene.start.inverseMass;
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        if (!scene.movesByVelocity(i))
            inverse[i] = 0.0;
    }
    return inverse;
}

bool isTurning(const Scene &scene)
{
    return scene.start.spin.rows() > 0;
}

/// Returns the inertia that a torque of the scene states, 0 for angles that are not dynamic. Empty if no
/// torque states it.
Eigen::ArrayXd inertiaOf(const Scene &scene)
{
    for (const EffectPtr &effect : scene.effects) {
        const auto *torque = as<Torque>(effect);
        Eigen::ArrayXd inertia = torque ? torque->inertia() : Eigen::ArrayXd();
        if (inertia.size() == scene.start.spin.size())
            return (inverseMassOf(scene) != 0.0).select(inertia, 0.0);
    }
    return {};
}

}

std::optional<NoEnergy> StoredEnergyReader::whyNot(const Scene &scene)
{
    for (const Group &group : scene.groups) {
        if (group.motion == Motion::prescribed)
            return NoEnergy::noInertia;
    }
    if ((inverseMassOf(scene) == 0.0).all())
        return NoEnergy::nothingMoves;
    if (isTurning(scene) && inertiaOf(scene).size() == 0)
        return NoEnergy::unknownForce;
    return {};
}

StoredEnergyReader::StoredEnergyReader(const Scene &scene)
    : m_turns(isTurning(scene)), m_inverseMass(inverseMassOf(scene))
{
    m_mass = m_turns ? inertiaOf(scene) : (m_inverseMass != 0.0).select(1.0 / m_inverseMass, 0.0);
    const State start = freed(scene.start);
    for (const EffectPtr &effect : scene.effects) {
        const auto *force = as<Force>(effect);
        const auto *torque = as<Torque>(effect);
        if (force && !m_turns && force->potentialEnergy(start))
            m_stores.push_back({effect, force, nullptr, force->conservesMomentum(start)});
        else if (torque && m_turns && torque->potentialEnergy(start))
            m_stores.push_back({effect, nullptr, torque, false});
    }
}

double StoredEnergyReader::Store::energy(const State &state) const
{
    return (force ? force->potentialEnergy(state) : torque->potentialEnergy(state)).value_or(0.0);
}

State StoredEnergyReader::freed(State state) const
{
    state.inverseMass = m_inverseMass;
    return state;
}

double StoredEnergyReader::moving(const State &state) const
{
    if (m_turns)
        return 0.5 * (m_mass * state.spin.square()).sum();
    return 0.5 * (m_mass * (state.velocity.col(0).square() + state.velocity.col(1).square())).sum();
}

double StoredEnergyReader::moving(const State &state, int point) const
{
    const Vec2 v = m_turns ? Vec2{state.spin[point], 0.0} : state.velocityOf(point);
    return 0.5 * m_mass[point] * dot(v, v);
}

Vec2 StoredEnergyReader::momentum(const State &state) const
{
    if (m_turns)
        return {};
    return {(m_mass * state.velocity.col(0)).sum(), (m_mass * state.velocity.col(1)).sum()};
}

double StoredEnergyReader::stored(const State &state) const
{
    const StoredEnergy stored = read(state);
    return stored.springs + stored.gravity;
}

StoredEnergy StoredEnergyReader::read(const State &state) const
{
    StoredEnergy stored;
    stored.moving = moving(state);
    stored.momentum = momentum(state);
    const State free = freed(state);
    for (const Store &store : m_stores)
        (store.effect->kind() == EffectKind::gravity ? stored.gravity : stored.springs) += store.energy(free);
    return stored;
}

const StoredEnergyReader::Store *StoredEnergyReader::find(const Effect &effect) const
{
    const auto found = std::find_if(m_stores.begin(), m_stores.end(),
                                    [&](const Store &store) { return store.effect.get() == &effect; });
    return found == m_stores.end() ? nullptr : &*found;
}

bool StoredEnergyReader::isStored(const Effect &effect) const
{
    return find(effect) != nullptr;
}

bool StoredEnergyReader::conservesMomentum(const Effect &effect) const
{
    const Store *store = find(effect);
    return store && store->conservesMomentum;
}

}
