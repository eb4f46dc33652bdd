#include "app/ui/scene/drawing/canvas.h"

#include "app/ui/scene/drawing/line_clip.h"

#include <QPainterPath>

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr double smallest = 2.0; ///< radius of a body, screen px
constexpr double farthest = 1e6; ///< screen px in either direction
constexpr double beyond = 64.0;  ///< how far lines extend beyond the area, to hide their ends

/// Returns the part of a polygon in which the dot product of `normal` and a point is at most `most`.
QPolygonF within(const QPolygonF &polygon, QPointF normal, double most)
{
    QPolygonF kept;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF from = polygon[i], to = polygon[(i + 1) % polygon.size()];
        const double a = QPointF::dotProduct(from, normal) - most, b = QPointF::dotProduct(to, normal) - most;
        if (a <= 0.0)
            kept << from;
        if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))
            kept << from + a / (a - b) * (to - from);
    }
    return kept;
}

}

QPointF Camera::at(sim::Vec2 place) const
{
    const QPointF p = toView.map(QPointF(place.x, place.y));
    return {std::clamp(p.x(), -farthest, farthest), std::clamp(p.y(), -farthest, farthest)};
}

sim::Vec2 Camera::back(QPointF place) const
{
    const QPointF p = toView.inverted().map(place);
    return {p.x(), p.y()};
}

double Camera::radius(double px) const
{
    return std::max(smallest, px * zoom);
}

bool Canvas::reaches(QPointF centre, double radius) const
{
    return area.adjusted(-radius, -radius, radius, radius).contains(centre);
}

QLineF Canvas::cut(QPointF from, QPointF to) const
{
    const QRectF room = area.adjusted(-beyond, -beyond, beyond, beyond);
    const auto part = partWithin(room, from, to);
    return part ? QLineF(from + part->first * (to - from), from + part->second * (to - from)) : QLineF();
}

QPolygonF Canvas::cut(QPolygonF polygon) const
{
    const QRectF room = area.adjusted(-beyond, -beyond, beyond, beyond);
    if (room.contains(polygon.boundingRect()))
        return polygon;
    polygon = within(polygon, {1.0, 0.0}, room.right());
    polygon = within(polygon, {-1.0, 0.0}, -room.left());
    polygon = within(polygon, {0.0, 1.0}, room.bottom());
    return within(polygon, {0.0, -1.0}, -room.top());
}

QPen dashed(const QColor &color, double width, std::initializer_list<double> pattern)
{
    QPen pen(color, width, Qt::CustomDashLine, Qt::FlatCap);
    QList<qreal> dashes;
    for (const double px : pattern)
        dashes << px / width;
    pen.setDashPattern(dashes);
    return pen;
}

QPen solid(const QColor &color, double width)
{
    return {color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void drawWords(const Canvas &canvas, const Words &words)
{
    QPainterPath path;
    path.addText(words.from, words.font, words.text);
    canvas.painter.strokePath(path, solid(canvas.tokens().scene, 4.0));
    canvas.painter.setPen(words.ink);
    canvas.painter.setFont(words.font);
    canvas.painter.drawText(words.from, words.text);
}

QColor faded(QColor color, double alpha)
{
    color.setAlphaF(static_cast<float>(alpha));
    return color;
}

}
