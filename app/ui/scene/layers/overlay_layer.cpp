// A layer of lines and labels that explain a step.

#include "app/ui/scene/drawing/overlay_labels.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/wind_overlay.h"
#include "lessons/api/view/view.h"

#include <cmath>
#include <numbers>

namespace app {

namespace {

using lessons::Overlay;

void drawCross(const Canvas &canvas, QPointF c)
{
    canvas.painter.setPen(solid(canvas.tokens().ink2, 1.5));
    canvas.painter.drawLine(c - QPointF(crossArm, 0), c + QPointF(crossArm, 0));
    canvas.painter.drawLine(c - QPointF(0, crossArm), c + QPointF(0, crossArm));
}

/// Draws an angle from the x axis, which points right. A positive angle turns clockwise on the screen,
/// because y points down.
void drawAngle(const Canvas &canvas, const Overlay &overlay)
{
    const QPointF c = canvas.camera.at(overlay.a);
    const double r = arcRadius(overlay, canvas.shown, canvas.camera);
    const double degrees = overlay.size * 180.0 / std::numbers::pi;
    QPainter &p = canvas.painter;
    p.setPen(solid(canvas.tokens().ink3, 1.0));
    p.drawLine(c, c + QPointF(r + beyondArc, 0.0));
    p.setPen(solid(canvas.tokens().ink2, 1.5));
    p.drawArc(QRectF(c.x() - r, c.y() - r, 2 * r, 2 * r), 0, static_cast<int>(std::lround(-16.0 * degrees)));
}

void drawOverlay(const Canvas &canvas, const Overlay &overlay)
{
    const QPointF a = canvas.camera.at(overlay.a);
    const double radius = ringRadius(overlay, canvas.camera);
    switch (overlay.shape) {
    case Overlay::Shape::cross:
        drawCross(canvas, a);
        break;
    case Overlay::Shape::ring:
        canvas.painter.setPen(dashed(canvas.tokens().ink3, 1.2, {2.0, 4.0}));
        canvas.painter.drawEllipse(a, radius, radius);
        break;
    case Overlay::Shape::arrow:
        drawArrow(canvas.painter, overlayArrow(overlay, canvas.shown, canvas.camera, canvas.theme),
                  canvas.tokens().scene);
        break;
    case Overlay::Shape::line:
        canvas.painter.setPen(dashed(canvas.tokens().ink2, 1.2, {5.0, 4.0}));
        canvas.painter.drawLine(canvas.cut(a, canvas.camera.at(overlay.b)));
        break;
    case Overlay::Shape::angle:
        drawAngle(canvas, overlay);
        break;
    case Overlay::Shape::wind:
        drawWind(canvas, a);
        break;
    }
}

void drawLabel(const Canvas &canvas, const OverlayLabel &label)
{
    const QPointF down(0.0, QFontMetricsF(canvas.shown.text).ascent());
    drawWords(canvas, {label.box.topLeft() + down, label.text, canvas.shown.text, canvas.tokens().ink2});
}

}

void drawOverlays(const Canvas &canvas)
{
    if (!canvas.shown.extras.overlays)
        return;
    for (const Overlay &overlay : canvas.shown.picture.overlays)
        drawOverlay(canvas, overlay);
    for (const OverlayLabel &label : overlayLabels(canvas.shown, canvas.camera, canvas.theme, canvas.area))
        drawLabel(canvas, label);
}

}
