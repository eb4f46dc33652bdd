#include "sim/methods/implicit/solvers/semidefinite.h"

#include <cmath>

namespace sim {

PairJacobian nearestNegativeSemidefinite(PairJacobian jacobian)
{
    const double mean = 0.5 * (jacobian.xx + jacobian.yy), half = 0.5 * (jacobian.xx - jacobian.yy);
    const double side = 0.5 * (jacobian.xy + jacobian.yx);
    const double radius = std::hypot(half, side);
    const double push = mean + radius; // the larger eigenvalue of the symmetric part
    if (push <= 0.0)
        return jacobian;
    if (mean - radius >= 0.0)
        return {0.0, 0.5 * (jacobian.xy - jacobian.yx), 0.5 * (jacobian.yx - jacobian.xy), 0.0};
    // The projection onto its eigenvector is (1 + c, n; n, 1 - c) / 2.
    const double c = half / radius, n = side / radius;
    jacobian.xx -= 0.5 * push * (1.0 + c);
    jacobian.yy -= 0.5 * push * (1.0 - c);
    jacobian.xy -= 0.5 * push * n;
    jacobian.yx -= 0.5 * push * n;
    return jacobian;
}

std::vector<Jacobian::Entry> nearestNegativeSemidefiniteBlocks(const Jacobian &jacobian, int points)
{
    std::vector<Jacobian::Entry> entries = jacobian.entries();
    for (std::size_t i = 0; i + 3 < entries.size();) {
        if (entries[i].row >= 2 * points) { // an angle: one entry, not a block of four
            ++i;
            continue;
        }
        const double sign = entries[i].row == entries[i].column ? 1.0 : -1.0;
        const PairJacobian kept = sign * nearestNegativeSemidefinite(
                                             sign * PairJacobian{entries[i].value, entries[i + 1].value,
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
