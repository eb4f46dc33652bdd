#include "sim/analysis/stability/limit.h"

#include <cmath>
#include <limits>

namespace sim {

namespace {

constexpr double minPhase = 1e-5;       ///< rad of the fastest mode
constexpr double startPhase = 0.01;     ///< rad, few limits are below
constexpr double maxPhase = 30.0;       ///< rad, no longer steps are searched
constexpr double limitTolerance = 1e-4; ///< relative to the step
/// At very short steps growth can vanish in rounding although every step is unstable. So growth must be well
/// above rounding a little past a real limit.
constexpr double factorPastLimit = 1.2;
constexpr double minGrowthPastLimit = 100.0; ///< times rounding

}

double findLimit(const std::function<double(double h)> &growth, double fastest, double rounding,
                 double searchRatio)
{
    const auto isStable = [&](double h) { return growth(h) <= rounding; };
    double stable = startPhase / fastest, unstable = 0.0;
    if (isStable(stable)) {
        const double longest = maxPhase / fastest;
        double h = stable;
        while (unstable == 0.0 && h < longest) {
            h *= searchRatio;
            (isStable(h) ? stable : unstable) = h;
        }
        if (unstable == 0.0)
            return std::numeric_limits<double>::infinity();
    } else {
        do {
            unstable = stable;
            stable = unstable / 4.0;
            if (stable < minPhase / fastest)
                return 0.0;
        } while (!isStable(stable));
    }
    while (unstable - stable > limitTolerance * unstable) {
        const double middle = std::sqrt(stable * unstable);
        (isStable(middle) ? stable : unstable) = middle;
    }
    return growth(factorPastLimit * unstable) > minGrowthPastLimit * rounding ? stable : 0.0;
}

}
