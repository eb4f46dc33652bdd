#pragma once

#include "sim/analysis/energy/balance.h"
#include "sim/run/track.h"

namespace sim {

class EnergyAccounting;

/// Where energy and momentum go in a run, row after row, by what its phases do:
/// - what a drag, a contact, a constraint, a driver or the hand changes is its own, exactly;
/// - a kick changes the kinetic energy by m h a (v + v')/2, which splits over the forces, exactly. What a force without
///   potential brings so is its work. What one with a potential brings must come out of what it has stored;
/// - a phase that is a whole step by itself is accounted for by integrals along its way: see Integrals;
/// - what then remains of the change of kinetic and stored energy is the method's error: the drift.
/// Reads the run, and changes nothing in it.
class Ledger
{
public:
    Ledger();
    ~Ledger();
    Ledger(Ledger &&) noexcept;
    Ledger &operator=(Ledger &&) noexcept;

    /// Of the row of `track` that ends at `frame`, which was computed before; empty where its scene has no energy:
    /// see Meter::whyNot().
    std::optional<Balance> row(const Track &track, std::int64_t frame);

private:
    std::shared_ptr<const EnergyAccounting>
    accountingOf(const std::shared_ptr<const ComposedInterval> &interval, DirectionRule directionRule);
    struct Kept
    {
        std::shared_ptr<const ComposedInterval> interval;
        std::shared_ptr<const EnergyAccounting> accounting; ///< null where the scene has no energy
    };
    std::vector<Kept> m_kept; ///< those last asked for
};

}
