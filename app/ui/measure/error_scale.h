#pragma once

#include "app/ui/theme/custom_plot.h"

#include <vector>

namespace app {

/// Where errors stand on a logarithmic axis. One of exactly 0 has no place on such an axis: it stands on a floor,
/// a stretch below all others, which is marked as 0 and not as a power of ten.
struct ErrorScale
{
    static constexpr double least = 1e-15; ///< px: what is smaller, and not 0, stands here
    static constexpr double most = 1e4;    ///< px: what is larger stands here

    double lower = 1e-9;  ///< px, the lower end of the axis
    double upper = 100.0; ///< px, its upper end
    double lowest = 0.0;  ///< px: below it, the axis has no numbers
    double floor = 0.0;   ///< px, where errors of 0 stand; 0: there are none

    double place(double error) const;
};

/// The scale for `errors` (px), with room above for a factor of `above`, on an axis of `height` px of the screen.
ErrorScale errorScale(const std::vector<double> &errors, double above, double height);

}
