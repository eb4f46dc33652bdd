#pragma once

#include <vector>

namespace app {

/// A logarithmic axis of errors. An error of exactly 0 has no place on such an axis, so it is on a floor, below all
/// others and marked as 0.
struct ErrorScale
{
    static constexpr double least = 1e-15; ///< px: smaller errors, except 0, are shown here
    static constexpr double most = 1e4;    ///< px: larger errors are shown here

    double lower = 1e-9;  ///< px, the lower end of the axis
    double upper = 100.0; ///< px, its upper end
    double lowest = 0.0;  ///< px: below it, the axis has no numbers
    double floor = 0.0;   ///< px, the place of errors of 0; 0 if there are none

    /// Returns the place of an error on the axis, in px.
    double place(double error) const;
};

/// Returns the scale for `errors` (px) on an axis of `height` px of the screen, with room above for a factor of
/// `above`.
ErrorScale errorScale(const std::vector<double> &errors, double above, double height);

}
