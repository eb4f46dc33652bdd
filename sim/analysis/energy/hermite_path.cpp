#include "sim/analysis/energy/hermite_path.h"

#include "sim/methods/adaptive/steps/hermite.h"

namespace sim {

HermitePath::HermitePath(const PathEnd &start, const PathEnd &end, double h)
    : m_coefficients(Eigen::ArrayXXd::Zero(start.positions.size(), 7)), m_h(h)
{
    for (Eigen::Index i = 0; i < m_coefficients.rows(); ++i) {
        const Quintic quintic =
            Quintic::through(start.positions[i], h * start.velocities[i], h * h * start.accelerations[i],
                             end.positions[i], h * end.velocities[i], h * h * end.accelerations[i]);
        for (int j = 0; j < 6; ++j)
            m_coefficients(i, j) = quintic.c[j];
    }
}

void HermitePath::evaluate(double time, Eigen::ArrayXd &positions, Eigen::ArrayXd &velocities) const
{
    const Eigen::Index rows = m_coefficients.rows();
    positions.resize(rows);
    velocities.resize(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const NewtonPolynomial polynomial =
            NewtonPolynomial::at<7>(m_coefficients.data() + i, static_cast<int>(rows), time / m_h);
        positions[i] = polynomial.value;
        velocities[i] = polynomial.derivative / m_h;
    }
}

void HermitePath::setMiddleAcceleration(const Eigen::ArrayXd &accelerations)
{
    const auto rows = static_cast<int>(m_coefficients.rows());
    for (int i = 0; i < rows; ++i)
        m_coefficients(i, 6) =
            NewtonPolynomial::seventh(m_coefficients.data() + i, rows, m_h * m_h * accelerations[i]);
}

const std::array<GaussNode, 5> &gaussNodes()
{
    static const std::array<GaussNode, 5> nodes = {{
        {0.046910077030668004, 0.11846344252809454},
        {0.23076534494715845, 0.23931433524968324},
        {0.5, 0.28444444444444444},
        {0.76923465505284155, 0.23931433524968324},
        {0.95308992296933200, 0.11846344252809454},
    }};
    return nodes;
}

}
