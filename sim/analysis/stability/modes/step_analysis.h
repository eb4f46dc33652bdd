#pragma once

#include "sim/analysis/stability/modes/linearised_scene.h"
#include "sim/analysis/stability/modes/spectrum.h"

#include <memory>

namespace sim {

/// A mode of a step: a displacement and the factor by which one step multiplies it.
struct Mode
{
    Eigen::VectorXcd rows; ///< displacement of each of LinearisedScene::rows
    std::complex<double> factor;
};

/// The effect of steps of one method on disturbances of one scene. `linearised` and `method` must outlive it.
class StepAnalysis
{
public:
    StepAnalysis(const LinearisedScene &linearised, const Method &method);
    virtual ~StepAnalysis() = default;

    /// Returns the largest modulus of an eigenvalue of the Jacobian, 1/frame^2; 0 without stiffness.
    double stiffest() const { return m_modes.empty() ? 0.0 : std::abs(m_jacobian.values()[m_modes.front()]); }
    /// Returns the growth rate of the motion itself, 1/frame; 0 if it does not grow.
    double motionGrowthRate() const { return m_motionGrowthRate; }
    /// Returns the logarithm of the factor by which a step of `h` frames multiplies disturbances, minus the
    /// growth of the motion itself.
    virtual double growth(double h) const = 0;
    /// Returns the rounding error of growth().
    virtual double rounding() const = 0;
    /// Returns the smallest step, in frames, at which disturbances grow; see findLimit().
    virtual double limit() const = 0;
    /// Returns the mode that grows most, or decays least, at steps of `h` frames.
    virtual Mode dominantMode(double h) const = 0;

protected:
    /// Returns an eigenvalue of the Jacobian, 1/frame^2. An imaginary part within rounding is removed.
    std::complex<double> eigenvalue(std::size_t index) const;

    const LinearisedScene &m_linearised;
    const Method &m_method;
    Spectrum m_jacobian; ///< of the Jacobian of all forces
    /// Indices of eigenvalues that are not 0, without copies and conjugates.
    std::vector<std::size_t> m_modes;

private:
    double m_motionGrowthRate = 0.0;
};

/// Returns an analysis of each mode, if the method computes all points at once and all have one damping rate.
/// Its steps then keep the modes apart. Otherwise returns an analysis of one step of the whole scene.
std::unique_ptr<StepAnalysis> stepAnalysisOf(const LinearisedScene &linearised, const Method &method);

}
