#pragma once

#include <functional>

namespace sim {

/// The smallest step, in frames, at which `growth` leaves 0: 0 where it is above at every step, infinity where it
/// never is. Past it, growth need not stay above: strong damping can hold very long steps again.
/// @param growth of the logarithm of what a step of h frames multiplies disturbances by, beyond what the motion does
/// @param fastest the fastest swing, in rad/frame: steps from 1e-5 to 30 rad of it are looked at
/// @param rounding what `growth` may be wrong by
/// @param fine the ratio of two steps that are looked at one after the other, before bisection to 1e-4 of the step
double findLimit(const std::function<double(double h)> &growth, double fastest, double rounding, double fine);

}
