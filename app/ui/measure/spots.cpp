#include "app/ui/measure/spots.h"

#include <cmath>

namespace app {

namespace {

constexpr double reach = 12.0; ///< px round the pointer in which a spot is found

}

const Spot *spotNear(const std::vector<Spot> &spots, const OnScreen &onScreen, QPointF at)
{
    const Spot *best = nullptr;
    double least = reach;
    for (const Spot &spot : spots) {
        const QPointF off = onScreen(spot) - at;
        const double away = std::hypot(off.x(), off.y());
        if (away < least) {
            least = away;
            best = &spot;
        }
    }
    return best;
}

const Spot *spotBeyond(const std::vector<Spot> &spots, const OnScreen &onScreen, const Spot &from, int along,
                       int across)
{
    const QPointF at = onScreen(from);
    const Spot *best = nullptr;
    double least = 0.0;
    for (const Spot &spot : spots) {
        const QPointF there = onScreen(spot);
        const double ahead =
            along != 0 ? along * (there.x() - at.x()) : across * (there.y() - at.y()); // px on the way
        if (ahead <= 0.0 || (along != 0) != (spot.line == from.line))
            continue;
        // Up and Down look for what is straight ahead.
        const double cost = along != 0 ? ahead : ahead + 2.0 * std::abs(there.x() - at.x());
        if (!best || cost < least) {
            best = &spot;
            least = cost;
        }
    }
    return best;
}

}
