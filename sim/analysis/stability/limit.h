#pragma once

#include <functional>

namespace sim {

/// Returns the smallest step, in frames, at which `growth` exceeds 0. Returns 0 if it does at every step,
/// infinity if it does at none. Beyond the limit growth may fall to 0 again: strong damping can make very
/// long steps stable.
/// @param growth logarithm of the factor by which a step of h frames multiplies disturbances, without the
/// growth of the motion itself
/// @param fastest the highest angular frequency, in rad/frame; steps of 1e-5 to 30 rad of it are searched
/// @param rounding error of `growth`
/// @param searchRatio ratio of two neighbouring steps in the search, before bisection to 1e-4 of the step
double findLimit(const std::function<double(double h)> &growth, double fastest, double rounding,
                 double searchRatio);

}
