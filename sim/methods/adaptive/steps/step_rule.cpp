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
    double largest = 0.0, sum = 0.0;
    for (int i = 0; i < size; ++i) {
        largest = std::max(largest, std::abs(numbers[i]));
        sum += numbers[i] - numbers[i]; // 0, or NaN
    }
    return sum == 0.0 ? largest : std::numeric_limits<double>::infinity();
}

}
