#include "sim/methods/tableau.h"

#include <cmath>

namespace sim {

namespace {

/// What of a velocity is left after `time` frames; a negative time undoes it.
double decay(double rate, double time)
{
    return rate == 0.0 ? 1.0 : std::exp(-rate * time);
}

}

void StageWeights::set(const Tableau &tableau, double rate, double h, int rows)
{
    if (std::isinf(rate)) {
        *this = {};
        return;
    }
    const auto last = static_cast<std::size_t>(rows);
    for (std::size_t i = 0; i < last; ++i)
        keep[i] = decay(rate, tableau.c[i] * h);
    keep[last] = decay(rate, h);
    // Quotients save most of the exponentials, as long as they are numbers.
    const bool quotients = rate * h < 300.0;
    for (std::size_t i = 0; i <= last; ++i) {
        const bool step = i == last;
        const Tableau::Row &a = step ? tableau.b : tableau.a[i];
        const double c = step ? 1.0 : tableau.c[i];
        for (std::size_t j = 0; j < i; ++j) {
            place[i][j] = h * a[j];
            if (rate == 0.0)
                speed[i][j] = place[i][j];
            else if (a[j] != 0.0)
                speed[i][j] =
                    place[i][j] * (quotients ? keep[i] / keep[j] : decay(rate, (c - tableau.c[j]) * h));
            else
                speed[i][j] = 0.0;
        }
    }
}

}
