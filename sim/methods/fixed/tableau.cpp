#include "sim/methods/fixed/tableau.h"

#include <cmath>

namespace sim {

namespace {

/// Returns the damping factor of a velocity after `time` frames, which may be negative.
double decay(double rate, double time)
{
    return rate == 0.0 ? 1.0 : std::exp(-rate * time);
}

}

void StageWeights::set(const Tableau &coefficients, double c, double step, int count)
{
    if (&coefficients == tableau && c == rate && step == h && count == rows)
        return;
    *this = {};
    tableau = &coefficients;
    rate = c;
    h = step;
    rows = count;
    if (std::isinf(rate))
        return;
    const auto last = static_cast<std::size_t>(rows);
    for (std::size_t i = 0; i < last; ++i)
        keep[i] = decay(rate, coefficients.c[i] * h);
    keep[last] = decay(rate, h);
    // Quotients save most of the exponentials. Beyond this limit they could be 0 / 0.
    const bool quotients = rate * h < 300.0;
    for (std::size_t i = 0; i <= last; ++i) {
        const Tableau::Row &a = i == last ? coefficients.b : coefficients.a[i];
        const double time = i == last ? 1.0 : coefficients.c[i];
        for (std::size_t j = 0; j < i; ++j) {
            if (a[j] == 0.0)
                continue;
            position[i][j] = h * a[j];
            if (rate == 0.0)
                velocity[i][j] = position[i][j];
            else
                velocity[i][j] = position[i][j] * (quotients ? keep[i] / keep[j]
                                                             : decay(rate, (time - coefficients.c[j]) * h));
        }
    }
}

}
