#include "sim/analysis/energy/hermite_path.h"

#include "sim/methods/adaptive/steps/hermite.h"

namespace sim {

HermitePath::HermitePath(const PathEnd &start, const PathEnd &end, double h)
    : m_columns(Eigen::ArrayXXd::Zero(start.place.size(), 7)), m_h(h)
{
    for (Eigen::Index i = 0; i < m_columns.rows(); ++i) {
        const Quintic all = Quintic::through(start.place[i], h * start.speed[i], h * h * start.slope[i],
                                             end.place[i], h * end.speed[i], h * h * end.slope[i]);
        for (int j = 0; j < 6; ++j)
            m_columns(i, j) = all.c[j];
    }
}

void HermitePath::at(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed) const
{
    const Eigen::Index rows = m_columns.rows();
    place.resize(rows);
    speed.resize(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const NewtonPolynomial at =
            NewtonPolynomial::at<7>(m_columns.data() + i, static_cast<int>(rows), time / m_h);
        place[i] = at.value;
        speed[i] = at.derivative / m_h;
    }
}

void HermitePath::bend(const Eigen::ArrayXd &slope)
{
    const auto rows = static_cast<int>(m_columns.rows());
    for (int i = 0; i < rows; ++i)
        m_columns(i, 6) = NewtonPolynomial::seventh(m_columns.data() + i, rows, m_h * m_h * slope[i]);
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
