// A layer that draws the Vec2 of the listing under the mouse.

#include "app/ui/scene/drawing/arrows.h"
#include "app/ui/scene/layers/layers.h"

#include <cmath>

namespace app {

namespace {

constexpr double vectorCrossArm = 8.0; ///< screen px
constexpr double vectorWidth = 2.0;
constexpr double labelAside = 12.0; ///< screen px, from the end of the arrow to its name

/// Returns how many times longer an arrow of `length` screen px is drawn, so that its direction can be seen: 1 or more.
int magnification(double length)
{
    constexpr double leastLength = 30.0; // screen px
    constexpr int factors[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
    for (const int factor : factors) {
        if (factor * length >= leastLength)
            return factor;
    }
    return 1; // nothing to see, for example a velocity of 0
}

void drawPlace(const Canvas &canvas, QPointF at)
{
    const QPointF across(vectorCrossArm, 0), up(0, vectorCrossArm);
    // The light stroke below keeps the cross visible on a body.
    for (const QPen &pen :
         {solid(canvas.tokens().scene, vectorWidth + 3.0), solid(canvas.tokens().ink, vectorWidth)}) {
        canvas.painter.setPen(pen);
        canvas.painter.drawLine(at - across, at + across);
        canvas.painter.drawLine(at - up, at + up);
    }
}

}

void drawVector(const Canvas &canvas)
{
    const std::optional<VectorMark> &vector = canvas.shown.vector;
    if (!vector || !std::isfinite(vector->to.x) || !std::isfinite(vector->to.y))
        return;
    const QPointF to = canvas.camera.at(vector->to);
    QPointF middle = to;
    QString name = vector->name;
    if (vector->kind == VectorMark::Kind::difference) {
        const QPointF from = canvas.camera.at(vector->from);
        const int times = magnification(std::hypot(to.x() - from.x(), to.y() - from.y()));
        const QPointF arrow = times * (to - from);
        drawArrow(canvas.painter, {from, arrow, {canvas.tokens().ink, vectorWidth}}, canvas.tokens().scene);
        middle = from + arrow / 2.0;
        if (times > 1)
            name = QStringLiteral("%1 × %2").arg(QString::number(times), name);
    } else {
        drawPlace(canvas, to);
    }
    const QPointF label = middle + QPointF(labelAside, -labelAside / 2.0);
    drawWords(canvas, {label, name, canvas.shown.figures, canvas.tokens().ink});
}

}
