#pragma once

#include "sim/pipeline/dense_segment.h"

#include <array>

namespace sim {

/// Places and velocities (in the order of Flow) at one end of a step, with the accelerations there.
struct PathEnd
{
    Eigen::ArrayXd place;
    Eigen::ArrayXd speed;
    Eigen::ArrayXd slope;
};

/// A motion through the places, velocities and accelerations of both ends of a step of `h` frames; see Quintic.
class HermitePath
{
public:
    HermitePath(const PathEnd &start, const PathEnd &end, double h);

    void at(double time, Eigen::ArrayXd &place, Eigen::ArrayXd &speed) const;
    /// Gives the motion the acceleration `slope` in the middle of the step. Both ends stay as they are.
    void bend(const Eigen::ArrayXd &slope);

private:
    Eigen::ArrayXXd m_columns; ///< the coefficients of each number of the motion, see Newton::at()
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
