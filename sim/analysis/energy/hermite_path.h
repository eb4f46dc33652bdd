#pragma once

#include "sim/pipeline/dense_segment.h"

#include <array>

namespace sim {

/// Positions, velocities and accelerations at one end of a step, in the order of OdeSystem.
struct PathEnd
{
    Eigen::ArrayXd positions;
    Eigen::ArrayXd velocities;
    Eigen::ArrayXd accelerations;
};

/// A motion through the positions, velocities and accelerations at both ends of a step of `h` frames; see
/// Quintic.
class HermitePath
{
public:
    HermitePath(const PathEnd &start, const PathEnd &end, double h);

    /// Computes positions and velocities `time` frames after the start of the step.
    void evaluate(double time, Eigen::ArrayXd &positions, Eigen::ArrayXd &velocities) const;
    /// Changes the motion to have these accelerations in the middle of the step. Both ends stay the same.
    void setMiddleAcceleration(const Eigen::ArrayXd &accelerations);

private:
    Eigen::ArrayXXd m_coefficients; ///< one row per coordinate, see NewtonPolynomial::at()
    double m_h;
};

/// A node of the five-point Gauss rule on 0 to 1, which is exact for polynomials up to degree 9.
/// Source: Abramowitz and Stegun, "Handbook of mathematical functions", table 25.4.
struct GaussNode
{
    double position;
    double weight;
};
/// Returns the five nodes in ascending order.
const std::array<GaussNode, 5> &gaussNodes();

}
