#include "app/ui/scene/hud/free_area.h"

#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double captionMargin = 20.0;
constexpr double captionTop = 12.0;
constexpr double belowCaption = 9.0;
constexpr double besideWall = 12.0;
constexpr double captionShift = 120.0; ///< the farthest that a wall moves a caption of several lines
constexpr double bottomRoom = 36.0;
constexpr double edge = 8.0;
constexpr double nameHeight = 20.0;
constexpr double belowBody = 11.0;
constexpr double leastCardRoom = 240.0; ///< px between two walls; if it is narrower, a card covers the walls

/// Returns the height of the caption at the smallest width that a wall may leave for it.
double captionHeight(const SceneContent &shown, QRectF view)
{
    const QRectF room(0.0, 0.0, view.width() - captionShift - captionMargin, view.height());
    return std::ceil(QFontMetricsF(shown.text).boundingRect(room, Qt::TextWordWrap, shown.caption).height());
}

}

QRectF captionBox(const SceneContent &shown, const Camera &camera, QRectF view)
{
    double x = captionMargin;
    if (const std::optional<sim::Room> &room = shown.view().room) {
        const double wall = camera.at({room->left, room->floor}).x();
        const double wide = QFontMetricsF(shown.text).horizontalAdvance(shown.caption);
        const double beside = std::round(wall + besideWall);
        const bool crosses =
            wall < captionMargin + wide && beside + wide + captionMargin <= view.width(); // and it fits there
        if (wall > captionMargin - besideWall && (wall < captionShift || crosses))
            x = beside; // keep the wall's line out of the text
    }
    return {x, captionTop, view.width() - x - captionMargin, captionHeight(shown, view)};
}

QRectF freeArea(const SceneContent &shown, QRectF view)
{
    const double top = captionTop + captionHeight(shown, view) + belowCaption;
    return view.adjusted(edge, shown.caption.isEmpty() ? edge : top, -edge, -bottomRoom);
}

QRectF cardArea(const SceneContent &shown, const Camera &camera, QRectF view)
{
    QRectF area = freeArea(shown, view);
    if (const std::optional<sim::Room> &room = shown.view().room) {
        const double left = camera.at({room->left, room->floor}).x() + edge;
        const double right = camera.at({room->right, room->floor}).x() - edge;
        if (std::min(right, area.right()) - std::max(left, area.left()) >= leastCardRoom) {
            area.setLeft(std::max(left, area.left()));
            area.setRight(std::min(right, area.right()));
        }
    }
    return area;
}

bool hasCard(const SceneContent &shown)
{
    return !shown.gathered.empty() && shown.selected >= 0;
}

QString selectedName(const SceneContent &shown)
{
    const auto point = static_cast<std::size_t>(shown.selected);
    return bodyTitle(QString::fromStdString(shown.picture.interval->scene.names[point]));
}

QRectF namePlace(const SceneContent &shown, const Camera &camera, QRectF view)
{
    if (shown.selected < 0 || shown.isHidden(shown.selected) || hasCard(shown))
        return {};
    const QPointF centre = camera.at(shown.state().positionOf(shown.selected));
    const double radius = camera.radius(shown.radius(shown.selected));
    if (!view.adjusted(-radius, -radius, radius, radius).contains(centre))
        return {};
    const double width = std::ceil(QFontMetricsF(shown.text).horizontalAdvance(selectedName(shown))) + 26.0;
    const QRectF free = freeArea(shown, view);
    double y = centre.y() + radius + belowBody;
    if (y + nameHeight > free.bottom())
        y = centre.y() - radius - belowBody - nameHeight;
    y = std::clamp(y, free.top(), std::max(free.top(), free.bottom() - nameHeight));
    const double x = std::clamp(centre.x() - 8.0, free.left(), std::max(free.left(), free.right() - width));
    return {x, y, width + 1.0, nameHeight + 1.0};
}

QRectF nameBox(const SceneContent &shown, const Camera &camera, QRectF view)
{
    const QRectF place = namePlace(shown, camera, view);
    if (place.isEmpty())
        return {};
    return {std::round(place.x()) + 0.5, std::round(place.y()) + 0.5, place.width() - 1.0,
            place.height() - 1.0};
}

}
