#pragma once

#include "sim/analysis/stability/modes/linearised_scene.h"
#include "sim/analysis/stability/modes/spectrum.h"
#include "sim/pipeline/pipeline.h"

namespace sim {

/// The linear map of positions and velocities that one step of a method applies to a small disturbance. It
/// runs the method itself and repeats none of its formulas.
class StepMap
{
public:
    /// Maps steps of `h` frames, any positive number. Positions are multiplied by `positionScale` (1/frame).
    /// The highest angular frequency makes positions and velocities comparable in size.
    /// @throws Error when the method cannot compute `linearised`
    StepMap(const LinearisedScene &linearised, const Method &method, double h, double positionScale);

    /// Returns the size of the vectors: positions of LinearisedScene::rows, then their velocities.
    int size() const { return 2 * static_cast<int>(m_linearised.rows.size()); }
    /// Computes one step from `in`.
    void operator()(const Eigen::VectorXd &in, Eigen::VectorXd &out);
    /// Returns the eigenvalues of the map: the factor by which a step multiplies each mode.
    Spectrum spectrum();

private:
    double &positionOf(int row);
    double &velocityOf(int row);

    const LinearisedScene &m_linearised;
    Pipeline m_pipeline;
    State m_state;
    double m_positionScale;
};

/// Returns the eigenvalues of a step of `h` frames on the oscillator x'' = lambda x - c x'. lambda is in
/// 1/frame^2, c in 1/frame.
Spectrum modeSpectrum(const Method &method, std::complex<double> lambda, double c, double h);

}
