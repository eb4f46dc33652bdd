#pragma once

#include "sim/analysis/stability/modes/linearised_scene.h"
#include "sim/analysis/stability/modes/spectrum.h"

#include <memory>

namespace sim {

/// A pattern of motion, and what one step multiplies it by.
struct Mode
{
    Eigen::VectorXcd rows; ///< how far each of Linear::rows goes
    std::complex<double> factor;
};

/// How steps of one method treat the disturbances of one scene. `linear` and `method` must outlive it.
class StepAnalysis
{
public:
    StepAnalysis(const LinearisedScene &linearised, const Method &method);
    virtual ~StepAnalysis() = default;

    /// The largest |lambda| of the pulls' slopes, in 1/frame^2; 0 where nothing swings.
    double stiffest() const { return m_swings.empty() ? 0.0 : std::abs(m_slopes.values()[m_swings.front()]); }
    /// How fast the motion itself grows, in 1/frame; 0 where it does not.
    double ownRate() const { return m_ownRate; }
    /// The logarithm of what a step of `h` frames multiplies disturbances by, beyond the motion itself.
    virtual double growth(double h) const = 0;
    /// What rounding does to it.
    virtual double rounding() const = 0;
    /// The smallest step at which disturbances grow: see findLimit().
    virtual double limit() const = 0;
    /// What grows most, or fades least, at steps of `h` frames.
    virtual Mode dominantMode(double h) const = 0;

protected:
    /// 1/frame^2; what is real but for rounding is real.
    std::complex<double> swing(std::size_t index) const;

    const LinearisedScene &m_linearised;
    const Method &m_method;
    Spectrum m_slopes;                 ///< of the pulls' slopes
    std::vector<std::size_t> m_swings; ///< those of its values that are not 0, and no copies of others

private:
    double m_ownRate = 0.0;
};

/// For a method that takes all points at once under one drag: each swing of the scene probed by itself, since such
/// steps keep them apart. For all others: one step of the whole scene.
std::unique_ptr<StepAnalysis> stepAnalysisOf(const LinearisedScene &linearised, const Method &method);

}
