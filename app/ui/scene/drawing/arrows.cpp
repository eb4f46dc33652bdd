#include "app/ui/scene/drawing/arrows.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double shortest = 3.0;     ///< screen px; a shorter arrow is only a head
constexpr double gap = 3.0;          ///< from a body's edge
constexpr double gapAtRing = 8.0;    ///< from the edge of the selected body
constexpr double besideSum = 16.0;   ///< offset of the sum from the centre
constexpr double besideTwin = 7.0;   ///< offset between two arrows of the same direction
constexpr double besidePull = 11.0;  ///< offset of a velocity beside a force of the same direction
constexpr double earlierWidth = 6.0; ///< of the arrow of an earlier velocity
constexpr double leastChange = 1.0;  ///< of a velocity, screen px; a smaller change would be invisible
constexpr double earlierAlpha = 0.3; ///< of the arrow of an earlier velocity
constexpr double twinCosine = 0.98;  ///< of the angle below which two directions count as the same

double lengthOf(QPointF v)
{
    return std::hypot(v.x(), v.y());
}

/// Calls `visit(point)` for the points that have arrows.
template <class Visit>
void forPointsWithArrows(const SceneContent &shown, Visit &&visit)
{
    if (shown.isCrowd()) {
        if (shown.selected >= 0)
            visit(shown.selected);
        return;
    }
    for (int i = 0; i < shown.points(); ++i)
        visit(i);
}

/// Returns an arrow of `vector` px that starts at the edge of the disc of `point`, offset sideways by `aside`
/// px.
Arrow atEdge(const SceneContent &shown, const Camera &camera, int point, QPointF vector, double aside)
{
    const double length = lengthOf(vector);
    const QPointF along = length > 0.0 ? vector / length : QPointF(0.0, 1.0);
    const QPointF across(-along.y(), along.x());
    const double radius = shown.isHidden(point) ? 0.0 : camera.radius(shown.radius(point));
    const double away = radius + (point == shown.selected ? gapAtRing : gap);
    Arrow arrow;
    arrow.from = camera.at(shown.state().positionOf(point)) + away * along + aside * across;
    arrow.vector = vector;
    return arrow;
}

QPointF scaled(sim::Vec2 v, double unit)
{
    return {v.x * unitArrow / unit, v.y * unitArrow / unit};
}

/// Returns whether an arrow of `vector` would cover the arrow of a force on the point.
bool liesOnPull(const SceneContent &shown, int point, QPointF vector)
{
    const auto isAlong = [&](const sim::ForceSnapshot &one) {
        const QPointF pull(one.acceleration(point, 0), one.acceleration(point, 1));
        return QPointF::dotProduct(pull, vector) > twinCosine * lengthOf(pull) * lengthOf(vector);
    };
    return std::any_of(shown.gathered.begin(), shown.gathered.end(), isAlong);
}

void addPullsAt(std::vector<Arrow> &arrows, const SceneContent &shown, const Camera &camera,
                const Theme &theme, int point)
{
    std::vector<QPointF> directions;
    for (const sim::ForceSnapshot &one : shown.gathered) {
        const QPointF vector =
            scaled({one.acceleration(point, 0), one.acceleration(point, 1)}, shown.scales.pull.unit);
        const double length = lengthOf(vector);
        if (!(length >= shortest))
            continue;
        double aside = 0.0;
        for (const QPointF &other : directions) {
            if (QPointF::dotProduct(other, vector) > twinCosine * length)
                aside += besideTwin;
        }
        directions.push_back(vector / length);
        Arrow arrow = atEdge(shown, camera, point, vector, aside);
        arrow.style = styleOf(one.effect->kind(), theme);
        arrow.style.width = shown.isBody(point) ? 4.0 : 3.0;
        arrows.push_back(arrow);
    }
}

}

QRectF Arrow::bounds() const
{
    return QRectF(from, from + vector).normalized().adjusted(-6, -6, 6, 6);
}

ArrowStyle styleOf(sim::EffectKind kind, const Theme &theme)
{
    using Line = ArrowStyle::Line;
    ArrowStyle style;
    style.color = theme.kindColor(kind);
    if (kind == sim::EffectKind::damping)
        style.line = Line::dashes;
    else if (kind == sim::EffectKind::wind)
        style.line = Line::dots;
    else if (kind == sim::EffectKind::driver)
        style.line = Line::twofold;
    else if (kind == sim::EffectKind::stick)
        style.line = Line::capped;
    else if (kind == sim::EffectKind::rule)
        style.line = Line::dashDots;
    return style;
}

ArrowStyle sumStyle(const Theme &theme)
{
    return {theme.tokens().ink, 2.0, ArrowStyle::Line::dots, false};
}

ArrowStyle velocityStyle(const Theme &theme)
{
    return {theme.tokens().ink2, 2.0, ArrowStyle::Line::plain, true};
}

void drawArrow(QPainter &painter, const Arrow &arrow, const QColor &ground)
{
    const double length = lengthOf(arrow.vector);
    if (!(length >= shortest))
        return;
    const ArrowStyle &style = arrow.style;
    const QPointF u = arrow.vector / length;
    const QPointF n(-u.y(), u.x());
    const QPointF tip = arrow.from + arrow.vector;
    const double whole = 9.0 + style.width * 0.6;
    // a short arrow has a small head, which must stay outside the body
    const double a = std::min(whole, length);
    const double b = (4.2 + style.width * 0.5) * a / whole;
    // The parts of a translucent arrow must not overlap, because overlaps would be darker.
    const bool isFaint = style.color.alpha() < 255;
    QPen pen = isFaint ? QPen(style.color, style.width, Qt::SolidLine, Qt::FlatCap)
                       : solid(style.color, style.width);
    if (style.line == ArrowStyle::Line::dashes)
        pen = dashed(style.color, style.width, {6.0, 3.0});
    else if (style.line == ArrowStyle::Line::dots)
        pen = dashed(style.color, style.width, {2.0 + style.width / 2, 4.0});
    else if (style.line == ArrowStyle::Line::dashDots)
        pen = dashed(style.color, style.width, {8.0, 4.0, 2.0, 4.0});
    painter.setPen(pen);
    const QLineF shaft(arrow.from, tip - (style.openHead ? 0.0 : a * (isFaint ? 1.0 : 0.7)) * u);
    painter.drawLine(shaft);
    if (style.line == ArrowStyle::Line::twofold) {
        painter.setPen(solid(ground, style.width / 3.0));
        painter.drawLine(shaft);
    } else if (style.line == ArrowStyle::Line::capped) {
        painter.drawLine(QLineF(arrow.from - b * n, arrow.from + b * n));
    }
    const QPolygonF head{tip - a * u + b * n, tip, tip - a * u - b * n};
    if (style.openHead) {
        painter.setPen(solid(style.color, style.width));
        painter.drawPolyline(head);
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.color);
    painter.drawPolygon(head);
    painter.setBrush(Qt::NoBrush);
}

std::vector<Arrow> pullArrows(const SceneContent &shown, const Camera &camera, const Theme &theme)
{
    std::vector<Arrow> arrows;
    if (shown.gathered.empty())
        return arrows;
    forPointsWithArrows(shown, [&](int point) { addPullsAt(arrows, shown, camera, theme, point); });
    if (shown.hasSum()) {
        const QPointF vector = scaled(shown.sumOnSelected(), shown.scales.pull.unit);
        const double aside = std::min(besideSum, camera.radius(shown.radius(shown.selected)));
        Arrow sum = atEdge(shown, camera, shown.selected, vector, aside);
        sum.style = sumStyle(theme);
        arrows.push_back(sum);
    }
    return arrows;
}

std::vector<Arrow> velocityArrows(const SceneContent &shown, const Camera &camera, const Theme &theme)
{
    std::vector<Arrow> arrows;
    if (!shown.showsVelocities())
        return arrows;
    const bool hasBefore = shown.before && shown.before->pointCount() == shown.points();
    forPointsWithArrows(shown, [&](int point) {
        if (shown.isHidden(point))
            return;
        const QPointF vector = scaled(shown.state().velocityOf(point), shown.scales.velocity.unit);
        const double aside = liesOnPull(shown, point, vector) ? -besidePull : 0.0;
        const ArrowStyle style = velocityStyle(theme);
        if (hasBefore) {
            const QPointF last = scaled(shown.before->velocityOf(point), shown.scales.velocity.unit);
            if (lengthOf(last - vector) >= leastChange) {
                Arrow earlier = atEdge(shown, camera, point, last, aside);
                earlier.style = {faded(style.color, earlierAlpha), earlierWidth};
                arrows.push_back(earlier);
            }
        }
        Arrow arrow = atEdge(shown, camera, point, vector, aside);
        arrow.style = style;
        arrows.push_back(arrow);
    });
    return arrows;
}

}
