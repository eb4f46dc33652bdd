#include "app/ui/scene/hud/edge_markers.h"

#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "app/ui/scene/drawing/label_places.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct EdgeMarkersText
{
    Q_DECLARE_TR_FUNCTIONS(EdgeMarkersText)
};

constexpr double arrowLength = 24.0;
constexpr double headLength = 12.0;
constexpr double headWidth = 13.0;
constexpr double shaftWidth = 4.0;
constexpr double labelGap = 5.0; ///< px between arrow and label
constexpr double shared = 44.0;  ///< px within which bodies share a marker

/// Returns the point where the line from the centre of `free` to `target` leaves `free`.
QPointF leaving(QRectF free, QPointF target)
{
    const QPointF middle = free.center();
    const QPointF d = target - middle;
    const double across = d.x() == 0.0 ? 0.0 : std::abs(d.x()) / (free.width() / 2);
    const double down = d.y() == 0.0 ? 0.0 : std::abs(d.y()) / (free.height() / 2);
    const double most = std::max({across, down, 1.0});
    return middle + d / most;
}

QString distanceText(double px)
{
    if (px >= 1e5)
        return pixels(roughNumber(px));
    return pixels(QString::number(std::llround(px)));
}

/// Returns an arrow with its tip at `tip`. It is much longer than wide, to show its direction clearly.
QPolygonF arrowTo(QPointF tip, QPointF u)
{
    const QPointF n(-u.y(), u.x());
    const QPointF tail = tip - arrowLength * u, neck = tip - headLength * u;
    const QPointF half = shaftWidth / 2.0 * n, wing = headWidth / 2.0 * n;
    return {tip, neck + wing, neck + half, tail + half, tail - half, neck - half, neck - wing};
}

void placeLabel(EdgeMarker &marker, const SceneContent &shown, QRectF free, LabelPlaces &places)
{
    const auto &names = shown.picture.interval->scene.names;
    const QString name =
        marker.bodies > 1 ? EdgeMarkersText::tr("%1 bodies").arg(marker.bodies)
                          : bodyTitle(QString::fromStdString(names[static_cast<std::size_t>(marker.point)]));
    marker.text = listed(name, distanceText(marker.away));
    const QFontMetricsF metrics(shown.text);
    const double w = std::ceil(metrics.horizontalAdvance(marker.text)) + 14.0;
    const double h = std::ceil(metrics.height()) + 5.0;
    // The label is on the inner side of the arrow and touches the arrow's end.
    const QPointF inner = marker.at - (arrowLength + labelGap) * marker.direction;
    const QPointF back(marker.direction.x() * w / 2, marker.direction.y() * h / 2);
    marker.label = places.within(free, inner - QPointF(w / 2, h / 2) - back, {w, h});
}

}

QRectF EdgeMarker::head() const
{
    return QRectF(at, at - arrowLength * direction).normalized().adjusted(-7, -7, 7, 7);
}

std::vector<EdgeMarker> edgeMarkers(const SceneContent &shown, const Camera &camera, QRectF view, QRectF free,
                                    std::vector<QRectF> taken)
{
    std::vector<EdgeMarker> markers;
    const bool isCrowd = shown.isCrowd();
    const int end = isCrowd ? shown.selected + 1 : shown.points();
    for (int i = isCrowd ? std::max(0, shown.selected) : 0; i < end; ++i) {
        if (shown.isHidden(i))
            continue;
        const QPointF centre = camera.at(shown.state().positionOf(i));
        const double radius = camera.radius(shown.radius(i));
        if (view.adjusted(-radius, -radius, radius, radius).contains(centre))
            continue;
        EdgeMarker marker;
        marker.point = i;
        marker.at = leaving(free, centre);
        const QPointF d = centre - marker.at;
        marker.direction = d / std::max(1e-9, std::hypot(d.x(), d.y()));
        marker.away = shownLength(shown.state().positionOf(i) - camera.back(marker.at));
        const auto near = std::find_if(markers.begin(), markers.end(), [&](const EdgeMarker &other) {
            return std::hypot(other.at.x() - marker.at.x(), other.at.y() - marker.at.y()) < shared;
        });
        if (near == markers.end()) {
            markers.push_back(marker);
            continue;
        }
        marker.bodies = near->bodies + 1;
        if (marker.away < near->away)
            *near = marker;
        near->bodies = marker.bodies;
    }
    for (const EdgeMarker &marker : markers)
        taken.push_back(marker.head());
    LabelPlaces places(std::move(taken));
    for (EdgeMarker &marker : markers)
        placeLabel(marker, shown, free, places);
    return markers;
}

void drawEdgeMarkers(QPainter &painter, const SceneContent &shown, const Theme &theme,
                     const std::vector<EdgeMarker> &markers)
{
    const Tokens &t = theme.tokens();
    painter.setFont(shown.text);
    for (const EdgeMarker &marker : markers) {
        const QPolygonF arrow = arrowTo(marker.at, marker.direction);
        painter.setBrush(t.body);
        painter.setPen(solid(t.scene, 3.0)); // an outline, for contrast with the scene behind
        painter.drawPolygon(arrow);
        painter.setPen(Qt::NoPen);
        painter.drawPolygon(arrow);
        const bool isPointedAt = marker.point == shown.outsidePointedAt;
        painter.setPen(QPen(isPointedAt ? t.ink : t.line2, isPointedAt ? 1.5 : 1.0));
        painter.setBrush(t.scene);
        painter.drawRoundedRect(marker.label.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
        painter.setPen(isPointedAt ? t.ink : t.ink2);
        painter.drawText(marker.label, Qt::AlignCenter | Qt::TextDontClip, marker.text);
    }
    painter.setBrush(Qt::NoBrush);
}

}
