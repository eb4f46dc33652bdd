#include "sim/methods/adaptive/steps/step_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

double dampingFactor(double rate, double time)
{
    return rate == 0.0 || std::isinf(rate) ? 1.0 : std::exp(-rate * time);
}

double maxAbs(const double *numbers, int size)
{
    double most = 0.0, sum = 0.0;
    for (int i = 0; i < size; ++i) {
        most = std::max(most, std::abs(numbers[i]));
        sum += numbers[i] - numbers[i]; // 0, or not a number
    }
    return sum == 0.0 ? most : std::numeric_limits<double>::infinity();
}

}
