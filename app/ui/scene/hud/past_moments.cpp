#include "app/ui/scene/hud/past_moments.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double reach = 7.0; ///< screen px around a line, or around the centre of a small body

/// The nearest moment so far.
struct Nearest
{
    double distance = reach; ///< screen px
    std::optional<std::int64_t> frame;

    void take(double length, std::int64_t at)
    {
        if (length >= distance)
            return;
        distance = length;
        frame = at;
    }
};

double length(QPointF way)
{
    return std::hypot(way.x(), way.y());
}

/// Returns the fraction, from 0 to 1, of the way from `a` to `b` at which the line is closest to `place`.
double shareOf(QPointF a, QPointF b, QPointF place)
{
    const QPointF way = b - a;
    const double square = QPointF::dotProduct(way, way);
    return square > 0.0 ? std::clamp(QPointF::dotProduct(place - a, way) / square, 0.0, 1.0) : 0.0;
}

void lookAtTrail(Nearest &nearest, const SceneContent &shown, const Camera &camera, QPointF place)
{
    const std::deque<Trail::Mark> &marks = shown.trail.marks();
    const std::vector<int> points = trailed(shown);
    if (points.empty())
        return;
    const std::int64_t now = marks.back().frame;
    for (std::size_t k = 1; k < marks.size(); ++k) {
        for (const int i : points) {
            const auto at = [&](const Trail::Mark &mark) {
                return camera.at({mark.position(i, 0), mark.position(i, 1)});
            };
            const QPointF from = at(marks[k - 1]), to = at(marks[k]);
            const double share = shareOf(from, to, place);
            const std::int64_t frame = marks[share < 0.5 ? k - 1 : k].frame;
            if (frame < now)
                nearest.take(length(from + share * (to - from) - place), frame);
        }
    }
}

void lookAtSkins(Nearest &nearest, const SceneContent &shown, const Camera &camera, QPointF place)
{
    for (const sim::State &skin : shown.onion) {
        for (int i = 0; skin.pointCount() == shown.points() && i < shown.points(); ++i) {
            const double radius = shown.isHidden(i) ? 0.0 : camera.radius(shown.radius(i));
            const double distance = length(camera.at(skin.positionOf(i)) - place);
            // Any place in a disc counts as a hit; the distance to the centre decides between several.
            if (!shown.isHidden(i) && distance <= std::max(radius, reach))
                nearest.take(distance * reach / std::max(radius, reach) * 0.999, skin.frame);
        }
    }
}

}

std::optional<std::int64_t> pastFrameAt(const SceneContent &shown, const Camera &camera, QPointF place)
{
    Nearest nearest;
    lookAtTrail(nearest, shown, camera, place);
    lookAtSkins(nearest, shown, camera, place);
    return nearest.frame;
}

}
