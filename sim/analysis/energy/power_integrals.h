#pragma once

#include "sim/analysis/energy/balance.h"
#include "sim/analysis/energy/hermite_path.h"
#include "sim/methods/ode_system.h"

namespace sim {

/// Computes energy and momentum of phases that are whole steps, in which forces and damping act continuously.
/// The work in each account is an integral along the path of the step.
class PowerIntegrals
{
public:
    /// `reader` must outlive this object.
    PowerIntegrals(const Scene &scene, const StoredEnergyReader &reader, DirectionRule directionRule);
    PowerIntegrals(const PowerIntegrals &) = delete; // m_wholeScene refers to m_system
    PowerIntegrals &operator=(const PowerIntegrals &) = delete;

    /// Adds a step of `h` frames from `before` to `after`, when only its two ends are known. The path is the
    /// quintic polynomial through both ends. Its error is estimated with a second path that also has the
    /// acceleration by forces and damping at the middle of the step. The difference is added to
    /// Balance::errorEstimate.
    void step(const State &before, const State &after, double h, Balance &balance) const;
    /// The state at the start of a phase that provides dense output, and a scratch state.
    class PhaseStart
    {
    public:
        explicit PhaseStart(const State &state);

    private:
        friend class PowerIntegrals;
        State m_start;
        State m_scratch;
    };
    /// Adds a dense segment of such a phase.
    void addSegment(PhaseStart &phaseStart, const DenseSegment &segment, Balance &balance) const;

private:
    /// An island, with its rows in the order of OdeSystem.
    struct Island
    {
        const OdeSystem &system;
        Eigen::ArrayXd rowMass; ///< of each row
        Eigen::ArrayXd rates;   ///< 1/frame, damping rate of each row
    };
    static Island islandOf(const OdeSystem &system, const StoredEnergyReader &reader);

    struct Sums
    {
        Accounts<double> energy;
        Accounts<Vec2> momentum;
    };
    /// Velocities at one node of the integral, and the weight of the node in frames.
    struct Moment
    {
        Eigen::ArrayXd velocities;
        double weight = 0.0;
    };
    using Path = std::function<void(double time, Eigen::ArrayXd &positions, Eigen::ArrayXd &velocities)>;

    /// Returns the scratch state, `time` frames into the phase, with the points of `island` at `positions`.
    /// It is valid until the next call.
    State &stateAt(PhaseStart &phaseStart, const Island &island, double time,
                   const Eigen::ArrayXd &positions) const;
    Sums integrate(PhaseStart &phaseStart, const Island &island, double start, double end,
                   const Path &path) const;
    void addPowers(State &state, const Island &island, const Moment &moment, Sums &sums) const;
    void addForce(const Force &force, State &state, const Island &island, const Moment &moment,
                  Sums &sums) const;
    void addTorque(const Torque &torque, const State &state, const Moment &moment, Sums &sums) const;
    double clockPower(const State &state) const;
    Eigen::ArrayXd accelerations(State &state, const Eigen::ArrayXd &velocities) const;
    void stopDampedRows(PathEnd &end) const;
    /// Returns the change of stored energy when the island moves from `from` to `to`.
    double storedEnergyChange(PhaseStart &phaseStart, const Island &island, double time,
                              const Eigen::ArrayXd &from, const Eigen::ArrayXd &to) const;
    static double kinetic(const Island &island, const Eigen::ArrayXd &velocities);
    /// Returns mass times `rate`, summed over the points: the total force from accelerations, the momentum
    /// from velocities.
    Vec2 massWeightedSum(const Island &island, const Eigen::ArrayXd &rate) const;
    void add(const Sums &sums, Balance &balance) const;

    const StoredEnergyReader &m_reader;
    OdeSystem m_system;
    DirectionRule m_directionRule;
    std::vector<EffectPtr> m_effects; ///< effects of the differential equation
    Island m_wholeScene;
    bool m_hasClocks = false;
    bool m_hasDrivers = false; ///< whether drivers or clocks place points
};

/// Returns the account of the work and the momentum by a force. The work counts only if the force stores no
/// energy, the momentum only if the force does not conserve it.
Account accountOf(const Effect &effect, const StoredEnergyReader &reader);

/// Returns the force (mass px/frame^2) by which the hand holds its point against `force`, a force that
/// conserves momentum, computed for `movers`.
Vec2 holdingForce(const Force &force, const State &state, PointRange movers, const StoredEnergyReader &reader,
                  DirectionRule directionRule);

}
