#include "sim/analysis/stability/modes/step_map.h"

#include "sim/simd/flush_denormals.h"

#include <cmath>

namespace sim {

StepMap::StepMap(const Linear &linear, const Method &method, double h, double balance)
    : m_linear(linear), m_pipeline(compose(linear.scene, method, {h, 1, 1, 0.0})),
      m_state(linear.scene.start), m_balance(balance)
{
    method.prepare(m_state);
}

double &StepMap::placeOf(int row)
{
    const int places = 2 * m_state.points();
    return row < places ? m_state.position.data()[row] : m_state.angle[row - places];
}

double &StepMap::speedOf(int row)
{
    const int places = 2 * m_state.points();
    return row < places ? m_state.velocity.data()[row] : m_state.spin[row - places];
}

void StepMap::operator()(const Eigen::VectorXd &in, Eigen::VectorXd &out)
{
    const auto rows = static_cast<Eigen::Index>(m_linear.rows.size());
    out.resize(2 * rows);
    Eigen::Index i = 0;
    for (const int row : m_linear.rows) {
        placeOf(row) = in[i] / m_balance;
        speedOf(row) = in[rows + i];
        ++i;
    }
    const FlushTiny flush;
    for (const Phase &phase : m_pipeline.phases)
        phase.run(m_state);
    i = 0;
    for (const int row : m_linear.rows) {
        out[i] = placeOf(row) * m_balance;
        out[rows + i] = speedOf(row);
        ++i;
    }
}

Spectrum StepMap::spectrum()
{
    return {size(), [this](const Eigen::VectorXd &in, Eigen::VectorXd &out) { (*this)(in, out); }};
}

Spectrum probe(const Method &method, std::complex<double> lambda, double c, double h)
{
    const Linear one = oscillator(method, lambda, c);
    return StepMap(one, method, h, std::sqrt(std::abs(lambda))).spectrum();
}

}
