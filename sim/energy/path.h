#pragma once

#include "sim/lap.h"

#include <array>

namespace sim {

/// Places and velocities (in the order of Flow) at one end of a step, with the accelerations there.
struct PathEnd
{
    Eigen::ArrayXd place;
    Eigen::ArrayXd speed;
    Eigen::ArrayXd slope;
};

/// The polynomial of degree 5 that has places, velocities and accelerations of both ends of a step of `h` frames. It
/// is off a smooth motion by h^6.
/// Source: Hairer, Norsett and Wanner, "Solving ordinary differential equations I", section II.6 (Hermite).
class HermitePath
{
public:
    HermitePath(PathEnd start, PathEnd end, double h);

    void at(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed) const;
    /// The acceleration in the middle.
    Eigen::ArrayXd middleSlope() const;
    /// Adds a bump that is nothing at both ends, in places, velocities and accelerations, and in the middle changes the
    /// acceleration by `slope`.
    void bend(const Eigen::ArrayXd &slope);

private:
    std::array<Eigen::ArrayXd, 7> m_powers; ///< of the share of the step
    double m_h;
};

/// Gauss's five nodes on 0 to 1 with their weights: exact for polynomials up to degree 9.
/// Source: Abramowitz and Stegun, "Handbook of mathematical functions", table 25.4.
struct GaussNode
{
    double share;
    double weight;
};
const std::array<GaussNode, 5> &gaussNodes();

}
