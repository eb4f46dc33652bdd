// Layers of solid things (rooms, ramps, the ground) and of the meadow below an open sky.

#include "app/model/picture/motion_area.h"
#include "app/ui/scene/hud/free_area.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/material.h"
#include "app/ui/scene/layers/sky.h"
#include "sim/effects/contacts/ramp.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <array>
#include <cmath>

namespace app {

namespace {

struct GroundLayersText
{
    Q_DECLARE_TR_FUNCTIONS(GroundLayersText)
};

constexpr double hatchStep = 12.0;   ///< screen px
constexpr double edgeShade = 26.0;   ///< screen px
constexpr double tickLength = 14.0;  ///< screen px
constexpr double leastTicks = 70.0;  ///< screen px between two distance labels
constexpr double finestTicks = 100.; ///< px between two distance labels
constexpr double besideNumber = 4.0; ///< screen px between a distance label and the edge of the view
constexpr double bottomLines = 32.0; ///< screen px at the bottom of the view, for the scale and legends
constexpr double leastBuried = 8.0;  ///< px; a branch this far below the ground shows through it

/// Draws the solid side of an edge, slightly darker close to the edge. `inwards`: direction from the edge
/// into the solid.
void drawSolid(const Canvas &canvas, const QRectF &box, QPointF edge, QPointF inwards)
{
    QPainter &p = canvas.painter;
    const QRectF seen = box.intersected(canvas.area);
    if (seen.isEmpty())
        return;
    const QColor ground = canvas.tokens().win;
    p.fillRect(seen, ground);
    if (isFlat(canvas.theme))
        return;
    QLinearGradient shade(edge, edge + edgeShade * inwards);
    shade.setColorAt(0.0, mixed(ground, canvas.theme.isDark() ? Qt::white : Qt::black, 0.1));
    shade.setColorAt(1.0, ground);
    const QRectF along = inwards.x() == 0.0 ? QRectF(seen.left(), edge.y(), seen.width(), edgeShade)
                                            : QRectF(inwards.x() < 0.0 ? edge.x() - edgeShade : edge.x(),
                                                     seen.top(), edgeShade, seen.height());
    p.fillRect(along.intersected(seen), shade);
}

double firstHatch(double from, double anchor)
{
    return from - std::fmod(from - anchor, hatchStep) - 2.0 * hatchStep;
}

void hatchFloor(QList<QLineF> &lines, double left, double right, double anchor, double y)
{
    for (double x = firstHatch(left, anchor); x < right; x += hatchStep)
        lines << QLineF(x, y + 10.0, x + 8.0, y + 1.0);
}

/// `solid`: the side on which the wall is solid, −1 or 1.
void hatchWall(QList<QLineF> &lines, double top, double bottom, double anchor, double x, double solid)
{
    for (double y = firstHatch(top, anchor); y < bottom - 8.0; y += hatchStep)
        lines << QLineF(x + solid * 10.0, y - solid * 4.0, x + solid, y + solid * 4.0);
}

/// Returns the px between two distance labels: 100, or more if the texts would be too close together.
double tickStep(double zoom)
{
    double step = finestTicks;
    for (const double factor : std::array{2.0, 2.5, 2.0, 2.0, 2.5, 2.0}) {
        if (step * zoom >= leastTicks)
            break;
        step *= factor;
    }
    return step;
}

/// Draws distances from the left of the stage below the ground line.
void drawDistances(const Canvas &canvas, double y)
{
    const double home = canvas.shown.view().stage.left();
    const double step = tickStep(canvas.camera.zoom);
    const double left = canvas.camera.back(canvas.area.topLeft()).x - home;
    const double right = canvas.camera.back(canvas.area.topRight()).x - home;
    QPainter &p = canvas.painter;
    p.setFont(canvas.shown.text);
    const QFontMetricsF metrics(canvas.shown.text);
    // Over the scale and legends, a second row of numbers would be unreadable.
    const bool hasRoom = y + tickLength + metrics.height() <= canvas.area.bottom() - bottomLines;
    const QRectF name = nameBox(canvas.shown, canvas.camera, canvas.area);
    QList<QLineF> ticks;
    for (double at = std::floor(left / step) * step; at <= right + step; at += step) {
        const double x = std::round(canvas.camera.at({home + at, 0.0}).x());
        ticks << QLineF(x, y, x, y + tickLength);
        if (!hasRoom)
            continue;
        const QString number = QString::number(std::abs(at), 'f', 0);
        const QString text =
            GroundLayersText::tr("%1\u202fpx").arg(at < 0.0 ? QChar(0x2212) + number : number);
        const double width = metrics.horizontalAdvance(text);
        const double start = x - width / 2.0;
        const QRectF box(start, y + tickLength + 1.0, width, metrics.height());
        // Part of a number would look like another number.
        if (start < canvas.area.left() + besideNumber || start + width > canvas.area.right() - besideNumber ||
            box.intersects(name))
            continue;
        p.setPen(canvas.tokens().ink3);
        p.drawText(QPointF(start, y + tickLength + metrics.ascent() + 1.0), text);
    }
    p.setPen(QPen(canvas.tokens().contact, 1.5, Qt::SolidLine, Qt::FlatCap));
    p.drawLines(ticks);
}

void drawRamp(const Canvas &canvas, const sim::Incline &edge)
{
    const QPointF normal(edge.normal.x, edge.normal.y), way(-normal.y(), normal.x());
    const QPointF place = canvas.camera.at(edge.through);
    const QPointF middle = canvas.area.center();
    const double reach = canvas.area.width() + canvas.area.height();
    if (std::abs(QPointF::dotProduct(middle - place, normal)) > reach)
        return;
    // The visible part of the line, extended to whole hatches.
    const double along = QPointF::dotProduct(middle - place, way);
    const double first = firstHatch(along - reach, 0.0), last = along + reach;
    const QPointF from = place + first * way, to = place + last * way;
    QPainter &p = canvas.painter;
    p.setPen(Qt::NoPen);
    p.setBrush(canvas.tokens().win);
    p.drawPolygon(QPolygonF{from, to, to - 2.0 * reach * normal, from - 2.0 * reach * normal});
    p.setBrush(Qt::NoBrush);
    QList<QLineF> hatch;
    for (double at = first; at < last; at += hatchStep) {
        const QPointF on = place + at * way;
        hatch << QLineF(on - 10.0 * normal, on + 8.0 * way - normal);
    }
    p.setPen(QPen(canvas.tokens().line2, 1.3, Qt::SolidLine, Qt::FlatCap));
    p.drawLines(hatch);
    p.setPen(QPen(canvas.tokens().contact, 2.0, Qt::SolidLine, Qt::FlatCap));
    p.drawLine(from, to);
}

}

void drawRoom(const Canvas &canvas)
{
    const std::optional<sim::Room> &room = canvas.shown.view().room;
    if (!room)
        return;
    QPainter &p = canvas.painter;
    const QRectF area = canvas.area;
    const QPointF low = canvas.camera.at({room->left, room->floor});
    const double left = std::round(low.x());
    const double right = std::round(canvas.camera.at({room->right, room->floor}).x());
    const double floor = std::round(low.y());
    const QPointF corner(left, floor);
    drawSolid(canvas, {QPointF(area.left(), floor), area.bottomRight()}, corner, {0.0, 1.0});
    drawSolid(canvas, {area.topLeft(), QPointF(left, floor)}, corner, {-1.0, 0.0});
    drawSolid(canvas, {QPointF(right, area.top()), QPointF(area.right(), floor)}, {right, floor}, {1.0, 0.0});

    QList<QLineF> hatch;
    if (floor < area.bottom() + 10.0)
        hatchFloor(hatch, std::max(left, area.left()), std::min(right, area.right()), left, floor);
    const double bottom = std::min(floor, area.bottom() + 10.0);
    if (left > area.left() - 10.0)
        hatchWall(hatch, area.top(), bottom, floor, left, -1.0);
    if (right < area.right() + 10.0)
        hatchWall(hatch, area.top(), bottom, floor, right, 1.0);
    p.setPen(QPen(canvas.tokens().line2, 1.3, Qt::SolidLine, Qt::FlatCap));
    p.drawLines(hatch);

    p.setPen(QPen(canvas.tokens().contact, 2.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    const double top = area.top() - 4.0;
    p.drawPolyline(
        QPolygonF{QPointF(left, top), QPointF(left, floor), QPointF(right, floor), QPointF(right, top)});
}

void drawRamps(const Canvas &canvas)
{
    for (const sim::EffectPtr &effect : canvas.shown.picture.interval->scene.effects) {
        if (const auto *ramp = dynamic_cast<const sim::Ramp *>(effect.get()))
            drawRamp(canvas, ramp->edge());
    }
}

void drawGround(const Canvas &canvas)
{
    const lessons::View &view = canvas.shown.view();
    if (!view.ground || view.sky != lessons::View::Sky::paper)
        return;
    const QRectF area = canvas.area;
    const QPointF home = canvas.camera.at({view.stage.left(), *view.ground});
    const double y = std::round(home.y());
    if (y > area.bottom() + 2.0)
        return;
    QPainter &p = canvas.painter;
    drawSolid(canvas, {QPointF(area.left(), y), area.bottomRight()}, {home.x(), y}, {0.0, 1.0});
    QList<QLineF> hatch;
    hatchFloor(hatch, area.left(), area.right(), home.x(), y);
    p.setPen(QPen(canvas.tokens().line2, 1.3, Qt::SolidLine, Qt::FlatCap));
    p.drawLines(hatch);
    drawDistances(canvas, y);
    p.setPen(QPen(canvas.tokens().contact, 2.0, Qt::SolidLine, Qt::FlatCap));
    p.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
}

void drawNearGround(const Canvas &canvas, TreePainter &tree)
{
    const lessons::View &view = canvas.shown.view();
    if (view.sky != lessons::View::Sky::dusk)
        return;
    const SkyColors colors = skyColors(canvas.theme.scheme());
    const QPolygonF meadow = drawMeadow(canvas, colors);
    const double deepest = horizonOf(canvas.shown) + leastBuried;
    const auto isBuried = [deepest](const Picture &one) {
        return one.view->tree && subjectBox(*one.view, one.state).bottom() >= deepest;
    };
    const bool isTreeBuried = isBuried(canvas.shown.picture);
    const bool isGhostBuried = canvas.shown.comparison && isBuried(*canvas.shown.comparison);
    if (!isTreeBuried && !isGhostBuried)
        return;
    // Branches can bend below the ground. They show through the meadow there, as in a cut-away drawing.
    QPainterPath outline;
    outline.addPolygon(meadow);
    canvas.painter.save();
    canvas.painter.setClipPath(outline, Qt::IntersectClip);
    if (isGhostBuried)
        drawComparison(canvas, tree);
    if (isTreeBuried)
        tree.draw(canvas, canvas.shown.picture.view, canvas.shown.state(), colors.buried);
    canvas.painter.restore();
}

}
