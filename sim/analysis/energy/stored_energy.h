#pragma once

#include "sim/scene/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace sim {

/// What a state holds. Energies in mass * px^2/frame^2 (where things turn: inertia * degrees^2/frame^2), momentum in
/// mass * px/frame.
struct StoredEnergy
{
    double moving = 0.0;  ///< kinetic: m v^2 / 2 of every point
    double springs = 0.0; ///< in what pulls back: springs, and joints that bend
    double gravity = 0.0; ///< of what lies high; at y = 0 it counts as 0
    Vec2 momentum;        ///< m v, summed up
    double total() const { return moving + springs + gravity; }
};

/// Why a scene has no energy that could be accounted for.
enum class NoEnergy {
    noInertia,    ///< some of its points have no velocity: they go where a rule puts them
    nothingMoves, ///< nothing in it goes on by itself
    unknownForce, ///< things turn, and nothing tells their inertia
    tooLarge,     ///< it has one, but counting it would take whoever waits for it too long
};

/// Reads energy and momentum off the states of one scene. A body in the hand counts like any other, with the mass
/// that it has when it is free: what the hand does to it is the hand's work.
class StoredEnergyReader
{
public:
    /// `scene` must have energy: see whyNot().
    explicit StoredEnergyReader(const Scene &scene);

    static std::optional<NoEnergy> whyNot(const Scene &scene);

    StoredEnergy read(const State &state) const;
    double moving(const State &state) const;
    /// Of one point alone.
    double moving(const State &state, int point) const;
    double stored(const State &state) const;
    Vec2 momentum(const State &state) const;

    /// 0 for what never feels anything; where things turn, their inertia.
    const Eigen::ArrayXd &mass() const { return m_mass; }
    bool turns() const { return m_turns; }
    /// Whether the ledger knows what `effect`, a Force or a Torque, has stored: so its work is no gain.
    bool isStored(const Effect &effect) const;
    /// Whether its pulls are nothing in sum, as long as nothing is held.
    bool conservesMomentum(const Effect &effect) const;
    /// `state` as if nothing were held.
    State freed(State state) const;

private:
    struct Store
    {
        EffectPtr effect;
        const Force *force = nullptr;
        const Torque *torque = nullptr;
        bool balances = false;
        double energy(const State &state) const;
    };
    const Store *find(const Effect &effect) const;

    bool m_turns = false;
    Eigen::ArrayXd m_mass;
    Eigen::ArrayXd m_inverseMass; ///< of points that nobody holds
    std::vector<Store> m_stores;
};

}
