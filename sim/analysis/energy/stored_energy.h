#pragma once

#include "sim/scene/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace sim {

/// The energy and momentum of a state. Energies are in mass px^2/frame^2, or in inertia degrees^2/frame^2 in
/// a scene of angles. The momentum is in mass px/frame.
struct StoredEnergy
{
    double moving = 0.0;  ///< kinetic energy: m v^2 / 2, summed over the points
    double springs = 0.0; ///< potential energy of springs and bent joints
    double gravity = 0.0; ///< potential energy of height; 0 at y = 0
    Vec2 momentum;        ///< m v, summed over the points

    /// Returns kinetic plus potential energy.
    double total() const { return moving + springs + gravity; }
};

/// The reason why a scene has no energy balance.
enum class NoEnergy {
    noInertia,    ///< some points move by prescribed motion and have no velocity
    nothingMoves, ///< no point is dynamic
    unknownForce, ///< angles turn, but no torque states their inertia
    tooLarge,     ///< the scene has energy, but computing the balance would take too long
};

/// Reads energy and momentum from the states of one scene. A body in the hand counts with the mass that it
/// has when free. Its changes are the work of the hand.
class StoredEnergyReader
{
public:
    /// `scene` must have energy, see whyNot().
    explicit StoredEnergyReader(const Scene &scene);

    /// Returns why `scene` has no energy balance, or nothing if it has one.
    static std::optional<NoEnergy> whyNot(const Scene &scene);

    /// Returns the energy and momentum of `state`.
    StoredEnergy read(const State &state) const;
    /// Returns the kinetic energy.
    double moving(const State &state) const;
    /// Returns the kinetic energy of one point.
    double moving(const State &state, int point) const;
    /// Returns the potential energy.
    double stored(const State &state) const;
    /// Returns the momentum; 0 in a scene of angles.
    Vec2 momentum(const State &state) const;

    /// Returns the mass of each point, or the inertia of each angle; 0 where forces have no effect.
    const Eigen::ArrayXd &mass() const { return m_mass; }
    /// Returns whether the scene is one of angles.
    bool turns() const { return m_turns; }
    /// Returns whether `effect`, a Force or a Torque, has a potential energy that is part of stored().
    bool isStored(const Effect &effect) const;
    /// Returns whether the forces of `effect` on all points add up to 0 while no point is held.
    bool conservesMomentum(const Effect &effect) const;
    /// Returns `state` with no point held.
    State freed(State state) const;

private:
    struct Store
    {
        EffectPtr effect;
        const Force *force = nullptr;
        const Torque *torque = nullptr;
        bool conservesMomentum = false;
        double energy(const State &state) const;
    };
    const Store *find(const Effect &effect) const;

    bool m_turns = false;
    Eigen::ArrayXd m_mass;
    Eigen::ArrayXd m_inverseMass; ///< with no point held
    std::vector<Store> m_stores;
};

}
