// Layers of bodies and their legs.

#include "app/ui/scene/drawing/eyes.h"
#include "app/ui/scene/drawing/figure.h"
#include "app/ui/scene/layers/crowd.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/material.h"
#include "lessons/api/view/view.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double ringGap = 5.0;
constexpr double eyesUp = 2.5 / 15.0; ///< of a body's radius
constexpr double thigh = 1.9;         ///< width of a leg at the body, as a multiple of its line width
constexpr double shin = 1.0;          ///< width of a leg at the foot, as a multiple of its line width
constexpr double leastLimb = 2.0;     ///< screen px; a thinner leg is drawn as a line
constexpr int curvePieces = 16;

/// Returns the width of a leg: 3 px at 260 %. It grows with the zoom, but more slowly.
double legWidth(double zoom)
{
    return std::clamp(3.0 * std::sqrt(zoom / 2.6), 1.5, 6.0);
}

/// Draws a limb, thick at the body and thin at the foot.
void drawLimb(const Canvas &canvas, const lessons::LegView &leg, double width)
{
    const sim::State &state = canvas.shown.state();
    const QPointF body = canvas.camera.at(state.positionOf(leg.from)),
                  foot = canvas.camera.at(state.positionOf(leg.to));
    const QPointF bend = leg.curve == 0.0
                             ? (body + foot) / 2.0
                             : canvas.camera.at(state.positionOf(leg.to) - sim::Vec2{0.0, leg.curve});
    const QRectF bounds = QPolygonF{body, bend, foot}.boundingRect().adjusted(-width, -width, width, width);
    if (!bounds.intersects(canvas.area))
        return;
    const int pieces = leg.curve == 0.0 ? 1 : curvePieces;
    QPolygonF outline(2 * (pieces + 1));
    QPointF across(0.0, 1.0);
    for (int i = 0; i <= pieces; ++i) {
        const double t = static_cast<double>(i) / pieces;
        const QPointF at = (1 - t) * (1 - t) * body + 2 * t * (1 - t) * bend + t * t * foot;
        const QPointF way = (1 - t) * (bend - body) + t * (foot - bend);
        const double length = std::hypot(way.x(), way.y());
        if (length > 0.0)
            across = QPointF(-way.y(), way.x()) / length;
        const QPointF half = 0.5 * width * (thigh + t * (shin - thigh)) * across;
        outline[i] = at + half;
        outline[2 * pieces + 1 - i] = at - half;
    }
    canvas.painter.drawPolygon(canvas.cut(outline), Qt::WindingFill);
}

/// Draws a hinge as a hollow disc: it turns freely.
void drawJoint(const Canvas &canvas, QPointF centre, double radius)
{
    const double rim = std::clamp(radius * 0.45, 1.0, 3.0);
    QPainter &p = canvas.painter;
    p.setPen(QPen(canvas.tokens().stick, rim));
    p.setBrush(canvas.tokens().scene);
    p.drawEllipse(centre, radius - rim / 2.0, radius - rim / 2.0);
    p.setPen(Qt::NoPen);
}

/// Returns whether the point is one of the small discs that are painted together.
bool isInCrowd(const Canvas &canvas, int point)
{
    using Shape = lessons::BodyView::Shape;
    const SceneContent &shown = canvas.shown;
    const bool isDisc = shown.shape(point) == Shape::body || shown.shape(point) == Shape::foot;
    return shown.isCrowd() && isDisc && shown.radius(point) * canvas.camera.zoom < smallestFace;
}

/// Draws the head of a nail: a cross in the disc, in the background's colour.
void drawNail(const Canvas &canvas, QPointF centre, double radius)
{
    const double arm = std::max(2.0, 0.45 * radius);
    QPainter &p = canvas.painter;
    p.setPen(solid(canvas.tokens().scene, std::clamp(0.3 * radius, 1.2, 3.0)));
    p.drawLine(centre - QPointF(arm, arm), centre + QPointF(arm, arm));
    p.drawLine(centre - QPointF(arm, -arm), centre + QPointF(arm, -arm));
    p.setPen(Qt::NoPen);
}

void drawBody(const Canvas &canvas, int point)
{
    const SceneContent &shown = canvas.shown;
    if (shown.isHidden(point))
        return;
    const QPointF centre = canvas.camera.at(shown.state().positionOf(point));
    const double radius = canvas.camera.radius(shown.radius(point));
    if (!canvas.reaches(centre, radius))
        return;
    const bool isFixed = shown.view().bodies[static_cast<std::size_t>(point)].fixed;
    if (shown.shape(point) == lessons::BodyView::Shape::joint && !isFixed) {
        drawJoint(canvas, centre, radius);
        return;
    }
    canvas.painter.setBrush(roundBrush(canvas, centre, radius, canvas.tokens().body));
    canvas.painter.drawEllipse(centre, radius, radius);
    if (isFixed)
        drawNail(canvas, centre, radius);
    else if (shown.extras.eyes && shown.isBody(point))
        drawEyes(canvas, {centre, radius, {1.0, 0.0}, {0.0, -eyesUp}, shown.state().velocityOf(point)});
}

}

void drawLegs(const Canvas &canvas, Stencil &stencil)
{
    const QColor color = faded(canvas.tokens().body, 0.85);
    const double width = legWidth(canvas.camera.zoom);
    if (!canvas.shown.isCrowd() && width >= leastLimb) {
        canvas.painter.setPen(Qt::NoPen);
        canvas.painter.setBrush(mixed(canvas.tokens().body, canvas.tokens().scene, 0.15));
        for (const lessons::LegView &leg : canvas.shown.view().legs)
            drawLimb(canvas, leg, width);
        canvas.painter.setBrush(Qt::NoBrush);
        return;
    }
    QPen pen = solid(color, width);
    pen.setCapStyle(Qt::FlatCap);
    canvas.painter.setPen(pen);
    const Figure figure{canvas.shown.view(), canvas.shown.state()};
    if (canvas.shown.isCrowd()) {
        begin(stencil, canvas);
        addLegs(stencil, canvas, figure, legWidthInCrowd(canvas.camera.zoom));
        stencil.paint(canvas.painter, color);
    } else {
        canvas.painter.drawLines(straightLegs(canvas, figure));
    }
    canvas.painter.drawPath(curvedLegs(canvas, figure));
}

void drawBodies(const Canvas &canvas, Stencil &stencil)
{
    const SceneContent &shown = canvas.shown;
    QPainter &p = canvas.painter;
    p.setPen(Qt::NoPen);
    if (shown.isCrowd()) {
        begin(stencil, canvas);
        addDiscs(stencil, canvas, {shown.view(), shown.state()}, smallestFace);
        stencil.paint(p, canvas.tokens().body);
    }
    for (int i = 0; i < shown.points(); ++i) {
        if (!isInCrowd(canvas, i))
            drawBody(canvas, i);
    }
    if (shown.selected < 0 || shown.isHidden(shown.selected))
        return;
    const QPointF centre = canvas.camera.at(shown.state().positionOf(shown.selected));
    const double radius = canvas.camera.radius(shown.radius(shown.selected)) + ringGap;
    if (!canvas.reaches(centre, radius))
        return;
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(canvas.tokens().ink, 1.5));
    p.drawEllipse(centre, radius, radius);
}

}
