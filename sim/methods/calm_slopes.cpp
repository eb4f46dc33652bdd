#include "sim/methods/calm_slopes.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// How one point's pull changes with one point's place: the numbers that Slopes::add() takes, and in its order.
struct Block
{
    double xx = 0.0;
    double xy = 0.0;
    double yx = 0.0;
    double yy = 0.0;
};

/// Leaves out of a block the direction in which it is positive.
Block withoutPush(Block s)
{
    const double middle = 0.5 * (s.xx + s.yy), apart = 0.5 * (s.xx - s.yy), side = 0.5 * (s.xy + s.yx);
    const double radius = std::hypot(apart, side);
    const double push = middle + radius; // the larger eigenvalue of the symmetric part
    if (push <= 0.0)
        return s;
    if (middle - radius >= 0.0 || radius == 0.0)
        return {};
    // Its eigenvector's outer product is half of 1 + the way to it from the middle.
    const double c = apart / radius, n = side / radius;
    s.xx -= 0.5 * push * (1.0 + c);
    s.yy -= 0.5 * push * (1.0 - c);
    s.xy -= 0.5 * push * n;
    s.yx -= 0.5 * push * n;
    return s;
}

}

std::vector<Slopes::Entry> calmed(const Slopes &slopes, int points)
{
    std::vector<Slopes::Entry> entries = slopes.entries();
    for (std::size_t i = 0; i + 3 < entries.size();) {
        if (entries[i].row >= 2 * points) { // an angle
            ++i;
            continue;
        }
        // By its own place a point is pulled back; by another's it is taken along.
        const double sign = entries[i].row == entries[i].column ? 1.0 : -1.0;
        const Block calm = withoutPush({sign * entries[i].value, sign * entries[i + 1].value,
                                        sign * entries[i + 2].value, sign * entries[i + 3].value});
        entries[i].value = sign * calm.xx;
        entries[i + 1].value = sign * calm.xy;
        entries[i + 2].value = sign * calm.yx;
        entries[i + 3].value = sign * calm.yy;
        i += 4;
    }
    return entries;
}

}
