#pragma once

#include "sim/analysis/energy/balance.h"
#include "sim/run/track.h"

namespace sim {

class EnergyAccounting;

/// Accounts for the energy and momentum of a run, one output step at a time:
/// - The change by a drag, contact, constraint, driver or the hand is the exact difference of the states
///   before and after it.
/// - A kick changes the kinetic energy by m h a (v + v')/2, which splits exactly over the forces. This is the
///   work of a force without potential. A force with a potential takes it from its stored energy.
/// - A phase that is a whole step is accounted for by integrals along its path, see PowerIntegrals.
/// - The remaining change of kinetic and stored energy is the drift, the error of the method.
/// The ledger only reads the run.
class Ledger
{
public:
    Ledger();
    ~Ledger();
    Ledger(Ledger &&) noexcept;
    Ledger &operator=(Ledger &&) noexcept;

    /// Returns the balance of the output step of `track` that ends at `frame` and has been computed. Empty if
    /// its scene has no energy, see StoredEnergyReader::whyNot().
    std::optional<Balance> balanceAt(const Track &track, std::int64_t frame);

private:
    std::shared_ptr<const EnergyAccounting>
    accountingOf(const std::shared_ptr<const ComposedInterval> &interval, DirectionRule directionRule);
    struct Kept
    {
        std::shared_ptr<const ComposedInterval> interval;
        std::shared_ptr<const EnergyAccounting> accounting; ///< null where the scene has no energy
    };
    std::vector<Kept> m_kept; ///< the last used
};

}
