#include "sim/analysis/stability/modes/step_map.h"

#include "sim/simd/flush_denormals.h"

#include <cmath>

namespace sim {

StepMap::StepMap(const LinearisedScene &linearised, const Method &method, double h, double balance)
    : m_linearised(linearised), m_pipeline(compose(linearised.scene, method, {h, 1, 1, 0.0})),
      m_state(linearised.scene.start), m_balance(balance)
{
    method.prepareState(m_state);
}

double &StepMap::placeOf(int row)
{
    const int places = 2 * m_state.pointCount();
    return row < places ? m_state.position.data()[row] : m_state.angle[row - places];
}

double &StepMap::speedOf(int row)
{
    const int places = 2 * m_state.pointCount();
    return row < places ? m_state.velocity.data()[row] : m_state.spin[row - places];
}

void StepMap::operator()(const Eigen::VectorXd &in, Eigen::VectorXd &out)
{
    const auto rows = static_cast<Eigen::Index>(m_linearised.rows.size());
    out.resize(2 * rows);
    Eigen::Index i = 0;
    for (const int row : m_linearised.rows) {
        placeOf(row) = in[i] / m_balance;
        speedOf(row) = in[rows + i];
        ++i;
    }
    const FlushDenormals flush;
    for (const Phase &phase : m_pipeline.phases)
        phase.run(m_state);
    i = 0;
    for (const int row : m_linearised.rows) {
        out[i] = placeOf(row) * m_balance;
        out[rows + i] = speedOf(row);
        ++i;
    }
}

Spectrum StepMap::spectrum()
{
    return {size(), [this](const Eigen::VectorXd &in, Eigen::VectorXd &out) { (*this)(in, out); }};
}

Spectrum modeSpectrum(const Method &method, std::complex<double> lambda, double c, double h)
{
    const LinearisedScene one = oscillator(method, lambda, c);
    return StepMap(one, method, h, std::sqrt(std::abs(lambda))).spectrum();
}

}
