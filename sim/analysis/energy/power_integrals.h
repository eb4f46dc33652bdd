#pragma once

#include "sim/analysis/energy/balance.h"
#include "sim/analysis/energy/hermite_path.h"
#include "sim/methods/ode_system.h"

namespace sim {

/// Energy and momentum of the phases that are whole steps by themselves, in which forces and damping act all along: the
/// physical accounts are integrals along the way that the step took.
class PowerIntegrals
{
public:
    /// `meter` must outlive this.
    PowerIntegrals(const Scene &scene, const StoredEnergyReader &reader, DirectionRule directionRule);
    PowerIntegrals(const PowerIntegrals &) = delete; // parts of it refer to each other
    PowerIntegrals &operator=(const PowerIntegrals &) = delete;

    /// A step of `h` frames from `before` to `after`, which tells its two ends only: along the polynomial of degree 5
    /// through them. How far that may be off the way is measured by the acceleration in its middle, against the one
    /// that forces and damping ask for there.
    void step(const State &before, const State &after, double h, Balance &into) const;
    /// A phase that tells its way itself: the state that it began in, and one to put islands of it anywhere.
    class Begun
    {
    public:
        explicit Begun(const State &state);

    private:
        friend class PowerIntegrals;
        State m_first;
        State m_now;
    };
    /// A lap of such a phase.
    void addSegment(Begun &begun, const DenseSegment &segment, Balance &into) const;

private:
    /// An island: its numbers are those of a Flow.
    struct Island
    {
        const OdeSystem &system;
        Eigen::ArrayXd rowMass; ///< of each number
        Eigen::ArrayXd rates;   ///< of damping, likewise: 1/frame
    };
    static Island islandOf(const OdeSystem &system, const StoredEnergyReader &reader);

    struct Sums
    {
        Accounts<double> energy;
        Accounts<Vec2> momentum;
    };
    /// Velocities at a moment, and how many frames it counts for.
    struct Moment
    {
        Eigen::ArrayXd speed;
        double weight = 0.0;
    };
    using Way = std::function<void(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed)>;

    /// The state at another time of a phase, with the points of an island at other places. It holds until the next call.
    State &at(Begun &begun, const Island &island, double time, const Eigen::ArrayXd &place) const;
    Sums along(Begun &begun, const Island &island, double start, double end, const Way &setup) const;
    void addPowers(State &state, const Island &island, const Moment &now, Sums &sums) const;
    void addForce(const Force &force, State &state, const Island &island, const Moment &now,
                  Sums &sums) const;
    void addTorque(const Torque &torque, const State &state, const Moment &now, Sums &sums) const;
    double clockPower(const State &state) const;
    Eigen::ArrayXd accelerations(State &state, const Eigen::ArrayXd &speed) const;
    void stop(PathEnd &end) const;
    /// What more is stored where an island jumps.
    double lifted(Begun &begun, const Island &island, double time, const Eigen::ArrayXd &from,
                  const Eigen::ArrayXd &to) const;
    static double kinetic(const Island &island, const Eigen::ArrayXd &speed);
    /// The sum of what each point is pushed with, from accelerations (or velocities).
    Vec2 pushOf(const Island &island, const Eigen::ArrayXd &rate) const;
    void book(const Sums &sums, Balance &into) const;

    const StoredEnergyReader &m_reader;
    OdeSystem m_system;
    DirectionRule m_directionRule;
    std::vector<EffectPtr> m_effects; ///< with which the flow goes
    Island m_all;                     ///< the whole scene
    bool m_ticks = false;             ///< whether clocks run
    bool m_drives = false;            ///< whether anything is placed by drivers, or by clocks
};

/// The account of what a force does: of its energy, if it has nothing stored, and of its momentum, if it does not
/// balance.
Account accountOf(const Effect &effect, const StoredEnergyReader &reader);

/// What the hand pushes with (mass px/frame^2) so that what it holds stays, against what a force that balances gives it
/// when it is the turn of `movers`.
Vec2 heldPush(const Force &force, const State &state, PointRange movers, const StoredEnergyReader &reader,
              DirectionRule directionRule);

}
