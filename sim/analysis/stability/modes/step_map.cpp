#include "sim/analysis/stability/modes/step_map.h"

#include "sim/simd/flush_denormals.h"

#include <cmath>

namespace sim {

StepMap::StepMap(const LinearisedScene &linearised, const Method &method, double h, double positionScale)
    : m_linearised(linearised), m_pipeline(compose(linearised.scene, method, {h, 1, 1, 0.0})),
      m_state(linearised.scene.start), m_positionScale(positionScale)
{
    method.prepareState(m_state);
}

double &StepMap::positionOf(int row)
{
    const int coordinates = 2 * m_state.pointCount();
    return row < coordinates ? m_state.position.data()[row] : m_state.angle[row - coordinates];
}

double &StepMap::velocityOf(int row)
{
    const int coordinates = 2 * m_state.pointCount();
    return row < coordinates ? m_state.velocity.data()[row] : m_state.spin[row - coordinates];
}

void StepMap::operator()(const Eigen::VectorXd &in, Eigen::VectorXd &out)
{
    const auto rows = static_cast<Eigen::Index>(m_linearised.rows.size());
    out.resize(2 * rows);
    Eigen::Index i = 0;
    for (const int row : m_linearised.rows) {
        positionOf(row) = in[i] / m_positionScale;
        velocityOf(row) = in[rows + i];
        ++i;
    }
    const FlushDenormals flush;
    for (const Phase &phase : m_pipeline.phases)
        phase.run(m_state);
    i = 0;
    for (const int row : m_linearised.rows) {
        out[i] = positionOf(row) * m_positionScale;
        out[rows + i] = velocityOf(row);
        ++i;
    }
}

Spectrum StepMap::spectrum()
{
    return {size(), [this](const Eigen::VectorXd &in, Eigen::VectorXd &out) { (*this)(in, out); }};
}

Spectrum modeSpectrum(const Method &method, std::complex<double> lambda, double c, double h)
{
    const LinearisedScene single = oscillator(method, lambda, c);
    return StepMap(single, method, h, std::sqrt(std::abs(lambda))).spectrum();
}

}
