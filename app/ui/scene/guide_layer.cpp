// Lines and names that explain what a step is about.

#include "app/ui/scene/guide_labels.h"
#include "app/ui/scene/layers.h"
#include "app/ui/scene/wind_guide.h"
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

/// From the x axis, which goes to the right; on the screen a positive angle turns clockwise, as y goes down.
void drawAngle(const Canvas &canvas, const Overlay &guide)
{
    const QPointF c = canvas.camera.at(guide.a);
    const double r = arcRadius(guide, canvas.shown, canvas.camera);
    const double degrees = guide.size * 180.0 / std::numbers::pi;
    QPainter &p = canvas.painter;
    p.setPen(solid(canvas.tokens().ink3, 1.0));
    p.drawLine(c, c + QPointF(r + beyondArc, 0.0));
    p.setPen(solid(canvas.tokens().ink2, 1.5));
    p.drawArc(QRectF(c.x() - r, c.y() - r, 2 * r, 2 * r), 0, static_cast<int>(std::lround(-16.0 * degrees)));
}

void drawGuide(const Canvas &canvas, const Overlay &guide)
{
    const QPointF a = canvas.camera.at(guide.a);
    const double radius = ringRadius(guide, canvas.camera);
    switch (guide.shape) {
    case Overlay::Shape::cross:
        drawCross(canvas, a);
        break;
    case Overlay::Shape::ring:
        canvas.painter.setPen(dashed(canvas.tokens().ink3, 1.2, {2.0, 4.0}));
        canvas.painter.drawEllipse(a, radius, radius);
        break;
    case Overlay::Shape::arrow:
        drawArrow(canvas.painter, guideArrow(guide, canvas.shown, canvas.camera, canvas.theme),
                  canvas.tokens().scene);
        break;
    case Overlay::Shape::line:
        canvas.painter.setPen(dashed(canvas.tokens().ink2, 1.2, {5.0, 4.0}));
        canvas.painter.drawLine(canvas.cut(a, canvas.camera.at(guide.b)));
        break;
    case Overlay::Shape::angle:
        drawAngle(canvas, guide);
        break;
    case Overlay::Shape::wind:
        drawWind(canvas, a);
        break;
    }
}

void drawLabel(const Canvas &canvas, const GuideLabel &label)
{
    const QPointF down(0.0, QFontMetricsF(canvas.shown.text).ascent());
    drawWords(canvas, {label.box.topLeft() + down, label.text, canvas.shown.text, canvas.tokens().ink2});
}

}

void GuideLayer::draw(const Canvas &canvas) const
{
    if (!canvas.shown.extras.guides)
        return;
    for (const Overlay &guide : canvas.shown.picture.guides)
        drawGuide(canvas, guide);
    for (const GuideLabel &label : guideLabels(canvas.shown, canvas.camera, canvas.theme, canvas.area))
        drawLabel(canvas, label);
}

}
