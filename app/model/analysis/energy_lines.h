#pragma once

#include "app/model/series/energy_series.h"

#include <QString>

#include <vector>

namespace app {

// The lines and texts of the energy and momentum ledgers.

/// The role of a line in the ledger.
enum class EnergyRole {
    held,    ///< the present amount
    brought, ///< the amount gained or lost since the start
    drift,   ///< the error of the method
};

/// One line of the ledger.
struct EnergyLine
{
    QString id;
    QString title;
    QString help; ///< one or two sentences
    EnergyRole role = EnergyRole::held;
    sim::EffectKind kind = sim::EffectKind::motion; ///< for its colour
    double amount = 0.0;                            ///< energy; for momentum the x component
    double across = 0.0;                            ///< for momentum the y component (down)
    double errorEstimate = 0.0;                     ///< by how much `amount` may be wrong
    /// "+125.7", "22.5", "+6.8 ± 0.2"; of momentum "+3.1, −0.4".
    QString number;
};

/// The ledger lines of a run. An account that is zero in all frames from the first to the last has no line.
class EnergyLines
{
public:
    /// Prepares the lines from the part of the run that `series` has counted so far.
    explicit EnergyLines(const EnergySeries &series);

    /// Returns the energy lines at `frame`, from the top of the stack to its bottom: the drift first, the present
    /// energies last. Empty if that frame is not counted.
    std::vector<EnergyLine> energyAt(std::int64_t frame) const;
    /// Returns the momentum lines at `frame` in the same way.
    std::vector<EnergyLine> momentumAt(std::int64_t frame) const;
    /// Returns the zero of potential energy from height: the lowest value of the run, so that the energy is never below
    /// 0.
    double lowest() const { return m_lowest; }

private:
    void include(const sim::Balance &balance);

    const EnergySeries &m_series;
    double m_lowest = 0.0;
    double m_scale = 0.0; ///< the largest energy of the run, and
    double m_push = 0.0;  ///< the largest momentum: numbers far below are rounding errors
    bool m_isHigh = false;
    bool m_hasSprings = false;
    sim::Accounts<bool> m_hasEnergy;
    sim::Accounts<bool> m_hasMomentum;
};

/// Formats a number for a line: "22.5", "−0.4".
QString energyNumber(double value);
/// Formats a gain or loss with its sign: "+125.7", "−0.4".
QString signedEnergyNumber(double value);
/// Explains why there is no ledger, and which scenes have one.
QString noEnergyWords(sim::NoEnergy why);
/// Returns the unit of energies: "px²/frame²", or "degrees²/frame²" for rotation.
QString energyUnit(bool turns);
QString momentumUnit();

}
