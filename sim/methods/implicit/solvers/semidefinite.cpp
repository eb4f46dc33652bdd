#include "sim/methods/implicit/solvers/semidefinite.h"

#include <cmath>

namespace sim {

Slope negativePart(Slope slope)
{
    const double mean = 0.5 * (slope.xx + slope.yy), half = 0.5 * (slope.xx - slope.yy);
    const double side = 0.5 * (slope.xy + slope.yx);
    const double radius = std::hypot(half, side);
    const double push = mean + radius; // the larger eigenvalue of the symmetric part
    if (push <= 0.0)
        return slope;
    if (mean - radius >= 0.0)
        return {0.0, 0.5 * (slope.xy - slope.yx), 0.5 * (slope.yx - slope.xy), 0.0};
    // The projection onto its eigenvector is (1 + c, n; n, 1 - c) / 2.
    const double c = half / radius, n = side / radius;
    slope.xx -= 0.5 * push * (1.0 + c);
    slope.yy -= 0.5 * push * (1.0 - c);
    slope.xy -= 0.5 * push * n;
    slope.yx -= 0.5 * push * n;
    return slope;
}

std::vector<Slopes::Entry> negativeParts(const Slopes &slopes, int points)
{
    std::vector<Slopes::Entry> entries = slopes.entries();
    for (std::size_t i = 0; i + 3 < entries.size();) {
        if (entries[i].row >= 2 * points) { // an angle: one entry, not a block of four
            ++i;
            continue;
        }
        const double sign = entries[i].row == entries[i].column ? 1.0 : -1.0;
        const Slope kept = sign * negativePart(sign * Slope{entries[i].value, entries[i + 1].value,
                                                            entries[i + 2].value, entries[i + 3].value});
        entries[i].value = kept.xx;
        entries[i + 1].value = kept.xy;
        entries[i + 2].value = kept.yx;
        entries[i + 3].value = kept.yy;
        i += 4;
    }
    return entries;
}

}
