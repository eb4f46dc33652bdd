// A layer that draws the Vec2 of the listing under the mouse.

#include "app/ui/scene/drawing/arrows.h"
#include "app/ui/scene/layers/layers.h"

#include <cmath>

namespace app {

namespace {

constexpr double vectorCrossArm = 8.0; ///< screen px
constexpr double vectorWidth = 2.0;
constexpr double labelAside = 12.0; ///< screen px, from the end of the arrow to its name

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

void VectorLayer::draw(const Canvas &canvas) const
{
    const std::optional<VectorMark> &vector = canvas.shown.vector;
    if (!vector || !std::isfinite(vector->to.x) || !std::isfinite(vector->to.y))
        return;
    const QPointF to = canvas.camera.at(vector->to);
    QPointF label = to;
    if (vector->kind == VectorMark::Kind::difference) {
        const QPointF from = canvas.camera.at(vector->from);
        drawArrow(canvas.painter, {from, to - from, {canvas.tokens().ink, vectorWidth}},
                  canvas.tokens().scene);
        label = (from + to) / 2.0;
    } else {
        drawPlace(canvas, to);
    }
    drawWords(canvas, {label + QPointF(labelAside, -labelAside / 2.0), vector->name, canvas.shown.figures,
                       canvas.tokens().ink});
}

}
