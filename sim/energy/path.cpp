#include "sim/energy/path.h"

namespace sim {

HermitePath::HermitePath(PathEnd start, PathEnd end, double h) : m_h(h)
{
    const Eigen::ArrayXd v0 = h * start.speed, v1 = h * end.speed;
    const Eigen::ArrayXd a0 = 0.5 * h * h * start.slope, a1 = 0.5 * h * h * end.slope;
    // What the first half of the powers, from the start alone, leaves at the end.
    const Eigen::ArrayXd x = end.place - start.place - v0 - a0;
    const Eigen::ArrayXd v = v1 - v0 - 2.0 * a0;
    const Eigen::ArrayXd a = a1 - a0;
    m_powers = {start.place,
                v0,
                a0,
                10.0 * x - 4.0 * v + a,
                -15.0 * x + 7.0 * v - 2.0 * a,
                6.0 * x - 3.0 * v + a,
                Eigen::ArrayXd::Zero(x.size())};
}

void HermitePath::at(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed) const
{
    const double s = time / m_h;
    place = m_powers[6];
    speed = 6.0 * m_powers[6];
    for (std::size_t i = 6; i-- > 0;) {
        place = place * s + m_powers[i];
        if (i > 0)
            speed = speed * s + static_cast<double>(i) * m_powers[i];
    }
    speed /= m_h;
}

Eigen::ArrayXd HermitePath::middleSlope() const
{
    Eigen::ArrayXd slope = Eigen::ArrayXd::Zero(m_powers[0].size());
    for (std::size_t i = 7; i-- > 2;)
        slope = 0.5 * slope + static_cast<double>(i * (i - 1)) * m_powers[i];
    return slope / (m_h * m_h);
}

void HermitePath::bend(const Eigen::ArrayXd &slope)
{
    // c s^3 (1 - s)^3 bends by -3/8 c in the middle.
    const Eigen::ArrayXd c = (-8.0 / 3.0) * m_h * m_h * slope;
    m_powers[3] += c;
    m_powers[4] -= 3.0 * c;
    m_powers[5] += 3.0 * c;
    m_powers[6] -= c;
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
