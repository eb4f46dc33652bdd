#pragma once

#include "sim/analysis/stability/modes/linearised_scene.h"
#include "sim/analysis/stability/modes/spectrum.h"
#include "sim/pipeline/pipeline.h"

namespace sim {

/// What one step of a method does to a small disturbance: a linear map of places and velocities, found by running the
/// method. No method's formula is here.
class StepMap
{
public:
    /// Steps of `h` frames, any positive number. Places count `balance` (1/frame) times: with about the fastest swing's
    /// speed, places and velocities are of one size.
    /// @throws Error when the method cannot compute `linear`
    StepMap(const LinearisedScene &linearised, const Method &method, double h, double balance);

    /// Numbers in and out: the places of Linear::rows, then their velocities.
    int size() const { return 2 * static_cast<int>(m_linearised.rows.size()); }
    void operator()(const Eigen::VectorXd &in, Eigen::VectorXd &out);
    /// Its eigenvalues: what a step multiplies each pattern of motion by.
    Spectrum spectrum();

private:
    double &placeOf(int row);
    double &speedOf(int row);

    const LinearisedScene &m_linearised;
    Pipeline m_pipeline;
    State m_state;
    double m_balance;
};

/// What a step of `h` frames does to a swing x'' = lambda x - c x': the eigenvalues of the method's own step. lambda in
/// 1/frame^2, c in 1/frame.
Spectrum modeSpectrum(const Method &method, std::complex<double> lambda, double c, double h);

}
