#include "app/ui/accuracy/error_scale.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double factorBelow = 4.0;    ///< a factor of room under the smallest error
constexpr double floorGap = 22.0;      ///< px of the screen from there to the floor
constexpr double underIt = 12.0;       ///< px of the screen under the floor
constexpr double shortestScale = 60.0; ///< px of the screen, at least, for the other errors

}

double ErrorScale::place(double error) const
{
    return error == 0.0 && floor > 0.0 ? floor : std::clamp(error, least, most);
}

ErrorScale errorScale(const std::vector<double> &errors, double above, double height)
{
    ErrorScale scale;
    double low = HUGE_VAL;
    double high = 0.0;
    for (const double error : errors) {
        if (error == 0.0)
            continue;
        low = std::min(low, scale.place(error));
        high = std::max(high, scale.place(error));
    }
    if (high > 0.0) {
        scale.lower = low / factorBelow;
        scale.upper = high * above;
    }
    scale.lowest = scale.lower;
    if (std::find(errors.begin(), errors.end(), 0.0) == errors.end())
        return scale;
    const double rest = std::max(shortestScale, height - floorGap - underIt);
    const double decades = std::log10(scale.upper / scale.lower) / rest; // a px
    scale.floor = scale.lower * std::pow(10.0, -floorGap * decades);
    scale.lower = scale.floor * std::pow(10.0, -underIt * decades);
    return scale;
}

}
