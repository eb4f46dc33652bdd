// Bodies, their legs and their ghosts.

#include "app/ui/scene/layers.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double smallestFace = 12.0; ///< radius on the screen from which a body has eyes
constexpr double ringGap = 5.0;
constexpr double drawnRadius = 15.0; ///< the radius that the places of the eyes are meant for
constexpr double lookFar = 6.0;      ///< px/frame at which the eyes look all the way

/// 3 px at 260 %, thinner and thicker with the zoom, but less than the zoom.
double legWidth(double zoom)
{
    return std::clamp(3.0 * std::sqrt(zoom / 2.6), 1.5, 6.0);
}

void drawEyes(const Canvas &canvas, QPointF centre, double radius, sim::Vec2 velocity)
{
    const double z = radius / drawnRadius;
    const double speed = sim::length(velocity);
    const double share = speed > 0.0 ? std::min(1.0, speed / lookFar) / speed : 0.0;
    const QPointF look(velocity.x * share, velocity.y * share);
    QPainter &p = canvas.painter;
    for (const double side : {-1.0, 1.0}) {
        const QPointF eye = centre + z * (QPointF(side * 5.2, -2.5) + 2.0 * look);
        p.setBrush(canvas.tokens().bodyInk);
        p.drawEllipse(eye, 3.6 * z, 3.6 * z);
        p.setBrush(canvas.tokens().body);
        p.drawEllipse(eye + 1.5 * z * look, 1.7 * z, 1.7 * z);
    }
}

void drawBody(const Canvas &canvas, int point)
{
    const Shown &shown = canvas.shown;
    const QPointF centre = canvas.camera.at(shown.state().at(point));
    const double radius = canvas.camera.radius(shown.radius(point));
    if (!canvas.reaches(centre, radius))
        return;
    QPainter &p = canvas.painter;
    p.setBrush(canvas.tokens().body);
    p.drawEllipse(centre, radius, radius);
    if (shown.extras.eyes && shown.isBody(point) && radius >= smallestFace)
        drawEyes(canvas, centre, radius, shown.state().speed(point));
}

}

void LegLayer::draw(const Canvas &canvas) const
{
    const sim::State &state = canvas.shown.state();
    QPen pen = solid(faded(canvas.tokens().body, 0.85), legWidth(canvas.camera.zoom));
    pen.setCapStyle(Qt::FlatCap);
    canvas.painter.setPen(pen);
    QList<QLineF> legs;
    for (const lessons::LegLook &leg : canvas.shown.picture.look.legs) {
        const QLineF line =
            canvas.cut(canvas.camera.at(state.at(leg.from)), canvas.camera.at(state.at(leg.to)));
        if (!line.isNull())
            legs << line;
    }
    canvas.painter.drawLines(legs);
}

void BodyLayer::draw(const Canvas &canvas) const
{
    const Shown &shown = canvas.shown;
    QPainter &p = canvas.painter;
    p.setPen(Qt::NoPen);
    for (int i = 0; i < shown.points(); ++i)
        drawBody(canvas, i);
    if (shown.selected < 0)
        return;
    const QPointF centre = canvas.camera.at(shown.state().at(shown.selected));
    const double radius = canvas.camera.radius(shown.radius(shown.selected)) + ringGap;
    if (!canvas.reaches(centre, radius))
        return;
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(canvas.tokens().ink, 1.5));
    p.drawEllipse(centre, radius, radius);
}

void GhostLayer::draw(const Canvas &canvas) const
{
    const std::optional<Picture> &ghost = canvas.shown.ghost;
    if (!ghost || !canvas.shown.extras.ghost)
        return;
    const QColor color = faded(canvas.tokens().ghost, 0.9);
    QPainter &p = canvas.painter;
    p.setPen(dashed(color, 1.5, {3.0, 4.0}));
    for (const lessons::LegLook &leg : ghost->look.legs) {
        const QLineF line = canvas.cut(canvas.camera.at(ghost->state.at(leg.from)),
                                       canvas.camera.at(ghost->state.at(leg.to)));
        if (!line.isNull())
            p.drawLine(line);
    }
    for (std::size_t i = 0; i < ghost->look.bodies.size(); ++i) {
        const bool isBody = ghost->look.bodies[i].shape == lessons::BodyLook::Shape::body;
        const double radius = canvas.camera.radius(ghost->look.bodies[i].radius);
        const QPointF centre = canvas.camera.at(ghost->state.at(static_cast<int>(i)));
        if (!canvas.reaches(centre, radius))
            continue;
        p.setPen(isBody ? dashed(color, 1.5, {3.0, 4.0}) : dashed(color, 1.5, {3.0, 3.0}));
        p.drawEllipse(centre, radius, radius);
    }
}

}
