#pragma once

#include "sim/analysis/energy/power_integrals.h"
#include "sim/run/track.h"

namespace sim {

/// Accounts for one composed interval of a run: how each phase changes energy and momentum.
class EnergyAccounting
{
public:
    /// The scene of `interval` must have energy, see StoredEnergyReader::whyNot(). `interval` must outlive
    /// this object.
    EnergyAccounting(const ComposedInterval &interval, DirectionRule directionRule);

    const StoredEnergyReader &reader() const { return m_reader; }
    /// Runs the phases of an output step on `state`, whose input has been applied, and adds the changes to
    /// `balance`.
    void outputStep(State &state, Balance &balance) const;

private:
    /// The acceleration by a force that no kick has consumed yet.
    struct PendingForce
    {
        EffectPtr effect;
        Eigen::ArrayX2d acceleration;
        Eigen::ArrayXd angularAcceleration;
        Vec2 holdingForce; ///< see holdingForce()
    };
    struct PendingForces
    {
        std::vector<PendingForce> forces;
        bool isConsumed = false; ///< whether a kick has used the forces: the next force starts a new sum
    };

    /// The states before and after a clock advanced in a step.
    struct ClockAdvance
    {
        State before;
        State after;
    };
    /// The part of a step that cannot be accounted for before the step ends.
    struct OpenStep
    {
        PendingForces pending;
        std::vector<ClockAdvance> clocks;
    };

    void step(State &state, Balance &balance) const;
    void runWholeStep(State &state, std::size_t first, std::size_t last, Balance &balance) const;
    void runPhase(const Phase &phase, State &state, OpenStep &openStep, Balance &balance) const;
    void addForce(const Phase &phase, const State &before, const State &after, PendingForces &pending,
                  Balance &balance) const;
    void addKick(const Phase &phase, const State &before, const State &after, PendingForces &pending,
                 Balance &balance) const;
    /// Adds the stored energy that a clock, such as a gait clock, supplies. Takes the mean of its effect at
    /// the positions before and after the step, because a clock runs while points move.
    void addClock(const ClockAdvance &advance, const State &start, const State &end, Balance &balance) const;
    void addChange(Account account, const State &before, const State &after, Balance &balance) const;

    const ComposedInterval &m_interval;
    DirectionRule m_directionRule;
    StoredEnergyReader m_reader;
    PowerIntegrals m_integrals;
};

}
