#pragma once

#include "app/model/energy_course.h"

#include <QString>

#include <vector>

namespace app {

// What a ledger of energy and momentum says, in lines and words.

/// What a line of the ledger counts.
enum class EnergyRole {
    held,    ///< what there is now
    brought, ///< what came in, or went out, since the start
    drift,   ///< what the method made or lost
};

/// One line of the ledger.
struct EnergyLine
{
    QString id;
    QString title;
    QString help; ///< one or two sentences
    EnergyRole role = EnergyRole::held;
    sim::EffectKind kind = sim::EffectKind::motion; ///< for its colour
    double amount = 0.0;                            ///< energy; of momentum the part along x
    double across = 0.0;                            ///< of momentum the part along y (down)
    double errorEstimate = 0.0;                     ///< by how much it may be off
    /// "+125.7", "22.5", "+6.8 ± 0.2"; of momentum "+3.1, −0.4".
    QString number;
};

/// Which lines a run has: what all its frames from the first to the last have nothing in has none.
class EnergyLines
{
public:
    /// From what is counted of a run so far.
    explicit EnergyLines(const EnergyCourse &course);

    /// The lines of energy at `frame`, from the top of the pile to its bottom: the drift first, what there is now last; none where that is not counted.
    std::vector<EnergyLine> energyAt(std::int64_t frame) const;
    /// The same of momentum.
    std::vector<EnergyLine> momentumAt(std::int64_t frame) const;
    /// What lies high counts from here: the lowest of the run, so that it is never below 0.
    double lowest() const { return m_lowest; }

private:
    void look(const sim::Balance &balance);

    const EnergyCourse &m_course;
    double m_lowest = 0.0;
    double m_scale = 0.0; ///< the largest energy and
    double m_push = 0.0;  ///< momentum of the run: what is far below is rounding
    bool m_isHigh = false;
    bool m_hasSprings = false;
    sim::Accounts<bool> m_hasEnergy;
    sim::Accounts<bool> m_hasMomentum;
};

/// A number as the lines write it: "22.5", "−0.4".
QString energyNumber(double value);
/// The same of what was brought or taken: "+125.7", "−0.4".
QString signedEnergyNumber(double value);
/// Why there is no ledger, and what would have one.
QString noEnergyWords(sim::NoEnergy why);
/// The unit of energies, "px²/frame²"; where things turn "degrees²/frame²".
QString energyUnit(bool turns);
QString momentumUnit();

}
