#pragma once

#include "sim/energy/balance.h"
#include "sim/energy/path.h"
#include "sim/flow.h"

namespace sim {

/// Energy and momentum of the phases that are whole steps by themselves, in which forces and damping act all along: the
/// physical accounts are integrals along the way that the step took.
class Integrals
{
public:
    /// `meter` must outlive this.
    Integrals(const Scene &scene, const Meter &meter, Directions directions);

    /// A step of `h` frames from `before` to `after`, which tells its two ends only: along the polynomial of degree 5
    /// through them. How far that may be off the way is measured by the acceleration in its middle, against the one
    /// that forces and damping ask for there.
    void step(const State &before, const State &after, double h, Balance &into) const;
    /// A lap of a step that tells its way itself, from when its phase began in state `begun`.
    void lap(const State &begun, const Lap &lap, Balance &into) const;

private:
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

    /// The state at another time of the phase that began in `begun`, and at other places.
    State at(const State &begun, double time, const Eigen::ArrayXd &place) const;
    Sums along(const State &begun, double start, double end, const Way &way) const;
    void addPowers(const State &state, const Moment &now, Sums &sums) const;
    void addForce(const Force &force, const State &state, const Moment &now, Sums &sums) const;
    void addTorque(const Torque &torque, const State &state, const Moment &now, Sums &sums) const;
    double clockPower(const State &state) const;
    Eigen::ArrayXd accelerations(State &state, const Eigen::ArrayXd &speed) const;
    void stop(PathEnd &end) const;
    double kinetic(const Eigen::ArrayXd &speed) const;
    /// The sum of what each point is pushed with, from accelerations (or velocities).
    Vec2 pushOf(const Eigen::ArrayXd &rate) const;
    void book(const Sums &sums, Balance &into) const;

    const Meter &m_meter;
    Flow m_flow;
    Directions m_directions;
    std::vector<EffectPtr> m_effects; ///< with which the flow goes
    Eigen::ArrayXd m_rowMass;         ///< of each number of the flow
    Eigen::ArrayXd m_rates;           ///< of damping, likewise: 1/frame
    bool m_ticks = false;             ///< whether clocks run
};

/// The account of what a force does: of its energy, if it has nothing stored, and of its momentum, if it does not
/// balance.
Account accountOf(const Effect &effect, const Meter &meter);

/// What the hand pushes with (mass px/frame^2) so that what it holds stays, against what a force that balances gives it
/// when it is the turn of `movers`.
Vec2 heldPush(const Force &force, const State &state, Points movers, const Meter &meter,
              Directions directions);

}
