#include "app/ui/scene/drawing/figure.h"

#include "app/ui/scene/layers/crowd.h"
#include "lessons/api/view/view.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int finest = 8;          ///< pieces of a chain between two of its points
constexpr double crowdDisc = 12.0; ///< screen px; the radius of the largest discs in the outline of a crowd
constexpr double crowdAlpha = 0.6;
constexpr double tipShare = 0.18; ///< width of a chain's tip, as a fraction of the width of its root

QPointF unit(QPointF v, QPointF otherwise)
{
    const double length = std::hypot(v.x(), v.y());
    return length > 1e-9 ? v / length : otherwise;
}

/// Returns a point on the spline from `b` to `c`, with the neighbours `a` and `d`.
QPointF onSpline(QPointF a, QPointF b, QPointF c, QPointF d, double t)
{
    const double t2 = t * t;
    const double t3 = t2 * t;
    return 0.5 * (2.0 * b + t * (c - a) + t2 * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                  t3 * (3.0 * b - a - 3.0 * c + d));
}

/// Returns points along the smooth curve through the points of a chain.
QPolygonF middleOf(const Canvas &canvas, const sim::State &state, const std::vector<int> &points)
{
    QPolygonF middle;
    const int last = static_cast<int>(points.size()) - 1;
    const auto at = [&](int i) {
        return canvas.camera.at(state.positionOf(points[static_cast<std::size_t>(std::clamp(i, 0, last))]));
    };
    for (int i = 0; i < last; ++i) {
        for (int k = 0; k < finest; ++k)
            middle << onSpline(at(i - 1), at(i), at(i + 1), at(i + 2), static_cast<double>(k) / finest);
    }
    middle << at(last);
    return middle;
}

bool canShow(const Canvas &canvas, const QRectF &bounds, double width)
{
    // Not QRectF::intersects(): the bounds of a horizontal line have no height and would intersect nothing.
    const QRectF area = canvas.area.adjusted(-width, -width, width, width);
    return bounds.right() >= area.left() && bounds.left() <= area.right() && bounds.bottom() >= area.top() &&
           bounds.top() <= area.bottom();
}

void drawDiscs(const Canvas &canvas, const Figure &figure, const OutlineStyle &style)
{
    using Shape = lessons::BodyView::Shape;
    for (std::size_t i = 0; i < figure.view.bodies.size(); ++i) {
        const lessons::BodyView &body = figure.view.bodies[i];
        if (body.shape == Shape::none)
            continue;
        const double radius = canvas.camera.radius(body.radius);
        const QPointF centre = canvas.camera.at(figure.state.positionOf(static_cast<int>(i)));
        if (!canvas.reaches(centre, radius))
            continue;
        if (style.isDashed)
            canvas.painter.setPen(
                dashed(style.color, style.width, {3.0, body.shape == Shape::body ? 4.0 : 3.0}));
        canvas.painter.drawEllipse(centre, radius, radius);
    }
}

/// Draws only legs and small discs, all in one call and without dashes.
void drawCrowdOutlines(const Canvas &canvas, const Figure &figure, const OutlineStyle &style)
{
    Stencil stencil;
    begin(stencil, canvas);
    addLegs(stencil, canvas, figure, std::min(style.width, legWidthInCrowd(canvas.camera.zoom)));
    addDiscs(stencil, canvas, figure, crowdDisc);
    stencil.paint(canvas.painter, faded(style.color, crowdAlpha * style.color.alphaF()));
}

}

sim::Vec2 endOf(const lessons::SpringView &spring, const sim::State &state)
{
    return spring.b < 0 ? spring.at : state.positionOf(spring.b) + spring.at;
}

QList<QLineF> straightLegs(const Canvas &canvas, const Figure &figure)
{
    QList<QLineF> lines;
    for (const lessons::LegView &leg : figure.view.legs) {
        if (leg.curve != 0.0)
            continue;
        const QLineF line = canvas.cut(canvas.camera.at(figure.state.positionOf(leg.from)),
                                       canvas.camera.at(figure.state.positionOf(leg.to)));
        if (!line.isNull())
            lines << line;
    }
    return lines;
}

QPainterPath curvedLegs(const Canvas &canvas, const Figure &figure)
{
    QPainterPath path;
    for (const lessons::LegView &leg : figure.view.legs) {
        if (leg.curve == 0.0)
            continue;
        const sim::Vec2 foot = figure.state.positionOf(leg.to);
        QPainterPath one(canvas.camera.at(foot));
        one.quadTo(canvas.camera.at(foot - sim::Vec2{0.0, leg.curve}),
                   canvas.camera.at(figure.state.positionOf(leg.from)));
        if (canShow(canvas, one.controlPointRect(), 8.0))
            path.addPath(one);
    }
    return path;
}

QPainterPath skinPath(const Canvas &canvas, const sim::State &state, const lessons::SkinView &skin)
{
    QPainterPath path;
    const int count = static_cast<int>(skin.outline.size());
    if (count < 3)
        return path;
    const auto at = [&](int i) {
        return canvas.camera.at(
            state.positionOf(skin.outline[static_cast<std::size_t>((i + count) % count)]));
    };
    path.moveTo(at(0));
    for (int i = 0; i < count; ++i)
        path.cubicTo(at(i) + (at(i + 1) - at(i - 1)) / 6.0, at(i + 1) - (at(i + 2) - at(i)) / 6.0, at(i + 1));
    path.closeSubpath();
    path.setFillRule(Qt::WindingFill);
    return path;
}

QPainterPath chainPath(const Canvas &canvas, const sim::State &state, const lessons::ChainView &chain)
{
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    if (chain.points.empty())
        return path;
    const QPolygonF middle = middleOf(canvas, state, chain.points);
    const double root = chain.width * canvas.camera.zoom / 2.0;
    const auto half = [&](qsizetype i) {
        const double way =
            static_cast<double>(i) / static_cast<double>(std::max<qsizetype>(1, middle.size() - 1));
        return std::max(0.5, root * (1.0 - (1.0 - tipShare) * way));
    };
    QPolygonF left;
    QPolygonF right;
    QPointF along(0.0, 1.0);
    for (qsizetype i = 0; i < middle.size(); ++i) {
        along =
            unit(middle[std::min(i + 1, middle.size() - 1)] - middle[std::max<qsizetype>(i - 1, 0)], along);
        const QPointF across(along.y(), -along.x());
        left << middle[i] + half(i) * across;
        right << middle[i] - half(i) * across;
    }
    std::reverse(right.begin(), right.end());
    path.addPolygon(left + right);
    path.closeSubpath();
    path.addEllipse(middle.front(), half(0), half(0));
    path.addEllipse(middle.back(), half(middle.size() - 1), half(middle.size() - 1));
    return path;
}

QPainterPath limbPath(const Canvas &canvas, const sim::State &state, const lessons::LimbView &limb)
{
    const QLineF line =
        canvas.cut(canvas.camera.at(state.positionOf(limb.a)), canvas.camera.at(state.positionOf(limb.b)));
    if (line.isNull())
        return {};
    QPainterPath middle(line.p1());
    middle.lineTo(line.p2());
    QPainterPathStroker stroker(
        QPen(Qt::black, limb.width * canvas.camera.zoom, Qt::SolidLine, Qt::RoundCap));
    return stroker.createStroke(middle);
}

void drawOutlines(const Canvas &canvas, const Figure &figure, const OutlineStyle &style)
{
    if (figure.state.pointCount() > crowdPoints && !figure.view.legs.empty()) {
        drawCrowdOutlines(canvas, figure, style);
        return;
    }
    QPainter &p = canvas.painter;
    p.setPen(style.isDashed ? dashed(style.color, style.width, {3.0, 4.0}) : solid(style.color, style.width));
    p.setBrush(Qt::NoBrush);
    for (const QLineF &leg : straightLegs(canvas, figure))
        p.drawLine(leg);
    p.drawPath(curvedLegs(canvas, figure));
    for (const lessons::StickView &stick : figure.view.sticks)
        p.drawLine(canvas.cut(canvas.camera.at(figure.state.positionOf(stick.a)),
                              canvas.camera.at(figure.state.positionOf(stick.b))));
    for (const lessons::SpringView &spring : figure.view.springs)
        p.drawLine(canvas.cut(canvas.camera.at(figure.state.positionOf(spring.a)),
                              canvas.camera.at(endOf(spring, figure.state))));
    p.setBrush(style.fill);
    for (const lessons::LimbView &limb : figure.view.limbs)
        p.drawPath(limbPath(canvas, figure.state, limb));
    for (const lessons::ChainView &chain : figure.view.chains)
        p.drawPath(chainPath(canvas, figure.state, chain).simplified());
    for (const lessons::SkinView &skin : figure.view.skins)
        p.drawPath(skinPath(canvas, figure.state, skin));
    drawDiscs(canvas, figure, style);
    p.setBrush(Qt::NoBrush);
}

}
